// SPDX-License-Identifier: Apache-2.0
// Minimizes the foldover functional of a patch until no cell of it is folded.
#pragma once

#include "elliptic/untangle_patch.h"

namespace hexweave {

/// Bounds of the work, in numbers and not in seconds: results must not depend on the machine.
struct UnfoldLimits {
    double epsilon = 0.2;  ///< to start with
    int newton_steps = 25;
    int steps_after = 2;       ///< once unfolded, so that the least corner is not barely positive
    double node_visits = 1e7;  ///< free nodes times linear iterations (an assembly: ten)
};

struct Unfolding {
    long folded = 0;  ///< cells that are left, of those that can be cured
    int newton_steps = 0;
    int linear_iterations = 0;
};

/// Moves the patch's free points, which has targets. Where it does not succeed, the points with the
/// fewest folded cells that it came by are kept.
Unfolding unfold(Patch& patch, const UnfoldLimits& limits);

}  // namespace hexweave
