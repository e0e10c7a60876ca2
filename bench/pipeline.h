// SPDX-License-Identifier: Apache-2.0
// A problem from start grid to finished grid as the program does it: solve, then untangle.
#pragma once

#include "bench/problems.h"

namespace hexweave::bench {

struct Finished {
    SolveResult solve;    ///< with what untangling did
    PointField elliptic;  ///< the grid before untangling
    double solve_seconds = 0;
    double untangle_seconds = 0;

    long folded_by_solve() const {
        return solve.untangling ? solve.untangling->folded_before : solve.folded_after;
    }
};

/// Replaces the start grid by the finished one.
Finished finish(Problem& problem, const EllipticOptions& options);

}  // namespace hexweave::bench
