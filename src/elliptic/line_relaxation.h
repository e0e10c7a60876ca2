// SPDX-License-Identifier: Apache-2.0
// The smoother: relaxation by lines along every axis in turn, in colours.
#pragma once

#include "elliptic/level.h"

namespace hexweave {

/// Relaxes level.corrections towards operator(corrections) = residuals, zero at the boundary: the
/// unknowns of a grid line are solved for at once, those of lines that do not touch at the same
/// time (two colours on a face, four in a block). First the lines along the last axis; then,
/// `sweeps` times, those along the others and along the last again: nothing is solved twice in a
/// row. The result does not depend on the number of threads.
void relax_lines(Level& level, int sweeps);

}  // namespace hexweave
