// SPDX-License-Identifier: Apache-2.0
// A problem from start grid to finished grid as the program does it: the solve and what follows.
#pragma once

#include "bench/problems.h"

namespace hexweave::bench {

/// Replaces the start grid by the finished one.
inline SolveResult finish(Problem& problem, const EllipticOptions& options) {
    return solve_elliptic(problem.points, problem.parameters, options);
}

}  // namespace hexweave::bench
