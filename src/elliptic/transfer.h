// SPDX-License-Identifier: Apache-2.0
// Between a level and the next coarser one. Both ways are linear in the parameters: a node between
// two coarse ones takes part of them by its distances in s (t, u), not in the index.
#pragma once

#include "elliptic/level.h"

namespace hexweave {

/// residuals <- weights * residuals.
void integrate_residuals(Level& level);

/// coarse.residuals <- the transpose of interpolation applied to the integrated residuals of
/// `finer`, which are used up.
void restrict_residuals(Level& finer, Level& coarse);

/// finer.corrections <- (points of coarse - points of finer) at the coarse nodes, interpolated
/// between them.
void interpolate_changes(Level& finer, const Level& coarse);

/// points += factor * corrections at interior nodes.
void add_corrections(Level& level, double factor);

}  // namespace hexweave
