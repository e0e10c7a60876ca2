// SPDX-License-Identifier: Apache-2.0
// The linear systems of the grid equations: BiCGSTAB on the three components at once.
#pragma once

#include "bench/yardsticks/grid_operator.h"
#include "bench/yardsticks/incomplete_lu.h"

namespace hexweave::bench {

struct LinearOptions {
    double reduction;  ///< of the residual
    int maximum_iterations;
};

/// Preconditioned BiCGSTAB [van der Vorst 1992]. The three components are one system with one set
/// of scalars: their operator is the same, and a rotation of space rotates the result.
class LinearSolver {
public:
    explicit LinearSolver(const NodeLattice& lattice);

    /// Solves operator(result) = -residual with zero boundary values: the displacement that would
    /// bring `residual`, the operator applied to the points, to zero. Iterates from zero; true when
    /// the residual fell as asked. Where it grew instead, the result is a single preconditioned
    /// step.
    bool solve(const Stencils& stencils, const Nodes& residual, const LinearOptions& options,
               Nodes& result);

private:
    NodeLattice lattice_;
    IncompleteLu preconditioner_;
    Nodes remainder_, direction_, image_, preconditioned_, second_image_;
};

}  // namespace hexweave::bench
