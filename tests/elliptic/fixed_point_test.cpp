// SPDX-License-Identifier: Apache-2.0
// The grid fulfils the discrete equations, by an evaluation that shares no code with the solver.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "elliptic/elliptic_solver.h"
#include "elliptic/poisson_equations.h"
#include "elliptic/shapes.h"

namespace hexweave {
namespace {

using shapes::largest_unfulfilled;
using shapes::Problem;

void check_solution(Problem problem) {
    INFO(problem.points.extent().ni << " x " << problem.points.extent().nj << " x "
                                    << problem.points.extent().nk);
    const double before = largest_unfulfilled(problem.points, problem.parameters);
    for (const double tolerance : {1e-3, 1e-8}) {
        PointField points = problem.points;
        const SolveResult result = solve_elliptic(points, problem.parameters, {tolerance, 200});
        CHECK(result.status == SolveStatus::converged);
        CHECK(result.displacement < tolerance);
        CHECK(result.folded_after == 0);
        const double after = largest_unfulfilled(points, problem.parameters);
        CHECK(after < tolerance);
        CHECK(after < before);
    }
}

void check_counts(const Extent& e) {
    Problem problem = e.nk == 1 ? shapes::clustered_saddle(e.ni, e.nj, 0.5 / e.nj)
                                : shapes::clustered_block(e, 0.5 / e.nk);
    const PointField start = problem.points;
    INFO(e.ni << " x " << e.nj << " x " << e.nk);
    const SolveResult result = solve_elliptic(problem.points, problem.parameters, {1e-6, 100});
    CHECK(result.status == SolveStatus::converged);
    CHECK(result.safeguards.empty());
    CHECK(result.folded_after == 0);
    CHECK(largest_unfulfilled(problem.points, problem.parameters) < 1e-6);
    for (int k = 0; k < e.nk; ++k) {
        CHECK(problem.points(0, 1, k) == start(0, 1, k));
        CHECK(problem.points(e.ni - 1, 1, k) == start(e.ni - 1, 1, k));
        CHECK(problem.points(1, 0, k) == start(1, 0, k));
        CHECK(problem.points(1, e.nj - 1, k) == start(1, e.nj - 1, k));
    }
}

}  // namespace

TEST_CASE("the equations written out have the solutions that they must have") {
    // s = log r / log 3 and the angle are harmonic: what is left is the error of differences, which
    // falls with their step as h^4 (a displacement of one node: h^2 times the second order).
    const auto map = [](double u, double v, double w) {
        return shapes::annulus(shapes::leaning(u, v, w));
    };
    const auto largest_at = [&](int n, int nk) {
        const Extent e{n, n, nk};
        const PointField points = shapes::sample(e, map);
        const ParameterField s = shapes::sample_parameters(e, shapes::leaning);
        double largest = 0;
        for (int k = nk > 1 ? 1 : 0; k < (nk > 1 ? nk - 1 : 1); ++k) {
            for (int j = 1; j < n - 1; ++j) {
                for (int i = 1; i < n - 1; ++i) {
                    largest = std::max(largest, norm(shapes::unfulfilled(points, s, i, j, k)));
                }
            }
        }
        return largest;
    };
    CHECK(std::log2(largest_at(17, 1) / largest_at(33, 1)) == Approx(4).margin(0.3));
    CHECK(std::log2(largest_at(9, 9) / largest_at(17, 17)) == Approx(4).margin(0.6));
}

TEST_CASE("the grid of a planar face with thin cells is a fixed point of the equations") {
    check_solution(shapes::meander(65, 33, 1.2));
    check_solution(shapes::ring(97, 49, 1e-5));
}

TEST_CASE("the grid of a minimal surface with thin cells is a fixed point of the equations") {
    check_solution(shapes::clustered_saddle(49, 41, 1e-5));
}

TEST_CASE("the grid of a block with thin cells is a fixed point of the equations") {
    check_solution(shapes::clustered_block({17, 19, 25}, 1e-5));
    check_solution(shapes::wavy_cube(14));
}

TEST_CASE("grids of any counts are fixed points of the equations") {
    const std::vector<int> counts{2, 3, 4, 5, 6, 7, 18, 47};
    for (const int ni : counts) {
        for (const int nj : counts) check_counts({ni, nj, 1});
    }
    const std::vector<int> few{2, 4, 5, 6, 7, 12};
    for (const int ni : few) {
        for (const int nj : few) {
            for (const int nk : few) check_counts({ni, nj, nk});
        }
    }
    for (const Extent& e : {Extent{47, 4, 4},
                            {4, 47, 4},
                            {4, 4, 47},
                            {47, 18, 4},
                            {18, 5, 47},
                            {3, 47, 18},
                            {3, 4, 5},
                            {5, 47, 4},
                            {4, 5, 47},
                            {18, 18, 18}}) {
        check_counts(e);
    }
}

TEST_CASE("grids of blocks one interior node thick are fixed points of the equations") {
    for (const Extent& e :
         {Extent{3, 3, 3}, Extent{47, 3, 3}, Extent{3, 47, 3}, Extent{3, 3, 47}, Extent{47, 18, 3},
          Extent{47, 17, 3}, Extent{33, 18, 3}, Extent{65, 33, 3}, Extent{129, 65, 3},
          Extent{47, 3, 18}, Extent{65, 3, 33}, Extent{3, 47, 18}}) {
        check_counts(e);
    }
}

TEST_CASE("a start grid that is the solution already is converged at once") {
    // Products of clustered lines, sheared: exact but for rounding, in every size and place.
    const auto sheared = [](double u, double v, double w) {
        const double t = std::expm1(5 * v) / std::expm1(5.0);
        return Vec3{1e3 + u + 0.3 * t, t - 0.2 * w, w + 0.1 * u};
    };
    const auto parameters = [](double u, double v, double w) {
        return Vec3{u, std::expm1(5 * v) / std::expm1(5.0), w};
    };
    for (const Extent e :
         {Extent{3, 3, 1}, {3, 4, 1}, {17, 9, 1}, {70, 70, 1}, {3, 3, 3}, {3, 9, 4}, {17, 18, 9}}) {
        for (const double tolerance : {1e-3, 1e-8}) {
            PointField points = shapes::sample(e, sheared);
            const SolveResult result =
                solve_elliptic(points, shapes::sample_parameters(e, parameters), {tolerance, 100});
            INFO(e.ni << " x " << e.nj << " x " << e.nk << ", " << result.displacement);
            CHECK(result.status == SolveStatus::converged);
            CHECK(result.cycles <= 4);  // the first ones in single precision, with its noise
        }
    }
}

}  // namespace hexweave
