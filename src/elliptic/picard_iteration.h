// SPDX-License-Identifier: Apache-2.0
// What is left to try where multigrid cycles do not converge: Picard iteration with a Krylov method
// as the linear solver. Slow, and robust.
#pragma once

#include "elliptic/best_iterate.h"
#include "elliptic/elliptic_solver.h"

namespace hexweave {

/// Picard iteration [Spekreijse & Boerstoel 1996, eqs. (43)-(45)] from `points`: coefficients from
/// the last grid and a loose linear solve for the step. With Safeguard::anderson_picard steps are
/// accelerated, with krylov_picard they are halved. Adds its steps to the result and sets its
/// status. Offers every grid to `best`; `points` is the solution, or the best where there is none.
void iterate_picard(PointField& points, const ParameterField& parameters,
                    const EllipticOptions& options, Safeguard kind, SolveResult& result,
                    BestIterate& best);

}  // namespace hexweave
