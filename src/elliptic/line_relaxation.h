// SPDX-License-Identifier: Apache-2.0
// The smoother: relaxation by lines along every axis in turn, in colours.
#pragma once

#include "elliptic/level.h"

namespace hexweave {

enum class SweepOrder { forward, backward };

/// One sweep over level.corrections towards operator(corrections) = residuals, zero at the
/// boundary: the unknowns of a grid line are solved for at once, those of lines that do not touch
/// at the same time (two colours on a face, four in a block), first lines along i, then j, then k;
/// backward the other way round. The result does not depend on the number of threads.
void relax_lines(Level& level, SweepOrder order);

}  // namespace hexweave
