// SPDX-License-Identifier: Apache-2.0
// Picard iteration [Spekreijse & Boerstoel 1996, eqs. (43)-(45)]: coefficients from the last grid,
// a linear solve for the step.
#pragma once

#include <functional>

#include "bench/yardsticks/grid_operator.h"
#include "bench/yardsticks/yardstick.h"

namespace hexweave::bench {

/// The residual reduction asked of every linear solver, and its most iterations.
inline constexpr double linear_reduction = 1e-2;
inline constexpr int linear_iterations = 100;

/// Sets `step` to the solution of operator(step) = -residual with zero boundary values.
using LinearSolve =
    std::function<void(const Stencils& stencils, const Nodes& residual, Nodes& step)>;

void picard(const Problem& problem, const LinearSolve& solve, const Look& look);

/// Picard iteration with BiCGSTAB preconditioned by ILU(0).
Yardstick ilu_picard();

}  // namespace hexweave::bench
