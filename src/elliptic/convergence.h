// SPDX-License-Identifier: Apache-2.0
// When a series of displacements has come to its end.
#pragma once

#include <vector>

namespace hexweave {

/// The factor by which the last of `steps` (displacements in cells) shrank, at worst; never
/// believed to be better than 0.1 or worse than 0.99, and 0.9 where there are too few of them to
/// tell.
double convergence_rate(const std::vector<double>& steps);

/// Whether the last step, and what is left to move were the steps to go on shrinking as they did
/// (the rest of a geometric series), are both below the tolerance.
bool has_converged(const std::vector<double>& steps, double tolerance);

}  // namespace hexweave
