// SPDX-License-Identifier: Apache-2.0
#include "bench/yardsticks/picard.h"

#include "bench/yardsticks/bicgstab.h"

namespace hexweave::bench {

void picard(const Problem& problem, const LinearSolve& solve, const Look& look) {
    const NodeLattice lattice(problem.points.extent());
    const std::size_t nodes = lattice.extent.nodes();
    Nodes points(nodes);
    Nodes parameters(nodes);
    for (std::size_t p = 0; p < nodes; ++p) {
        points[p] = problem.points[p];
        parameters[p] = {problem.parameters.s[p], problem.parameters.t[p],
                         lattice.axes == 3 ? problem.parameters.u[p] : 0};
    }
    Nodes residual(nodes);
    Nodes step(nodes);
    Stencils stencils;
    const auto copy = [&](PointField& to) {
        for (std::size_t p = 0; p < nodes; ++p) to.set(p, points[p]);
    };
    int cycles = 0;
    do {
        assemble_stencils(lattice, points, parameters, stencils);
        apply_stencils(lattice, stencils, points, residual);
        solve(stencils, residual, step);
        for_interior(lattice, [&](std::size_t p) { points[p] += step[p]; });
    } while (look(++cycles, copy));
}

Yardstick ilu_picard() {
    const auto run = [](const Problem& problem, const Look& look) {
        LinearSolver linear{NodeLattice(problem.points.extent())};
        const auto solve = [&](const Stencils& stencils, const Nodes& residual, Nodes& step) {
            linear.solve(stencils, residual, {linear_reduction, linear_iterations}, step);
        };
        picard(problem, solve, look);
    };
    return {"ILU-BiCGSTAB", "Picard + ILU(0)-BiCGSTAB", run};
}

}  // namespace hexweave::bench
