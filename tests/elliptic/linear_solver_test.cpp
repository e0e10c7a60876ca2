// SPDX-License-Identifier: Apache-2.0
// The linear solver finds displacements that were put in.
#include "elliptic/linear_solver.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "elliptic/incomplete_lu.h"
#include "elliptic/shapes.h"

namespace hexweave {
namespace {

struct LinearProblem {
    NodeLattice lattice;
    Stencils stencils;
    Nodes displacement;  ///< put in
    Nodes residual;      ///< minus the operator applied to it
};

LinearProblem linear_problem(const shapes::Problem& problem) {
    LinearProblem result{NodeLattice(problem.points.extent()), {}, {}, {}};
    const Nodes points = shapes::nodes_of(problem.points);
    assemble_stencils(result.lattice, points, shapes::nodes_of(problem.parameters),
                      result.stencils);
    result.displacement.resize(points.size());
    result.residual.resize(points.size());
    for_interior(result.lattice, [&](std::size_t p) {
        const auto n = static_cast<double>(p);
        result.displacement[p] = {std::sin(n), std::cos(3 * n), std::sin(7 * n)};
    });
    apply_stencils(result.lattice, result.stencils, result.displacement, result.residual);
    for (Vec3& r : result.residual) r = -r;
    return result;
}

double largest_difference(const Nodes& a, const Nodes& b) {
    double largest = 0;
    for (std::size_t p = 0; p < a.size(); ++p) largest = std::max(largest, distance(a[p], b[p]));
    return largest;
}

}  // namespace

TEST_CASE("a displacement is found again from its residual") {
    for (const shapes::Problem& problem : {shapes::meander(33, 17, 1.2), shapes::wavy_cube(9)}) {
        const LinearProblem p = linear_problem(problem);
        LinearSolver solver(p.lattice);
        Nodes result(p.residual.size());
        CHECK(solver.solve(p.stencils, p.residual, {1e-12, 200}, result));
        CHECK(largest_difference(result, p.displacement) < 1e-8);
    }
}

TEST_CASE("too few linear iterations are told, and still bring the residual down") {
    const LinearProblem p = linear_problem(shapes::wavy_cube(9));
    LinearSolver solver(p.lattice);
    Nodes result(p.residual.size());
    CHECK_FALSE(solver.solve(p.stencils, p.residual, {1e-12, 2}, result));
    CHECK(largest_difference(result, p.displacement) <
          largest_difference(Nodes(result.size()), p.displacement));
}

TEST_CASE("no residual asks for no displacement") {
    const LinearProblem p = linear_problem(shapes::wavy_cube(5));
    LinearSolver solver(p.lattice);
    Nodes result(p.residual.size(), Vec3{1, 1, 1});
    CHECK(solver.solve(p.stencils, Nodes(result.size()), {1e-2, 100}, result));
    CHECK(largest_difference(result, Nodes(result.size())) == 0);
}

TEST_CASE(
    "factors of a single line of nodes, in any direction, are exact but for single precision") {
    const auto map = [](double xi, double eta, double zeta) {
        return shapes::annulus(shapes::leaning(xi, eta, zeta));
    };
    for (const Extent e :
         {Extent{9, 3, 1}, Extent{3, 9, 1}, Extent{9, 3, 3}, Extent{3, 9, 3}, Extent{3, 3, 9}}) {
        const LinearProblem p =
            linear_problem({shapes::sample(e, map), shapes::sample_parameters(e, shapes::leaning)});
        IncompleteLu factors(p.lattice);
        factors.factor(p.stencils);
        Nodes result(p.residual.size());
        factors.solve(p.residual, result);
        CHECK(largest_difference(result, p.displacement) < 1e-5);
    }
}

}  // namespace hexweave
