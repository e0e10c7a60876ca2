// SPDX-License-Identifier: Apache-2.0
// What the solver promises whatever the shape: fixed boundaries, honest statuses, one answer.
#include "elliptic/elliptic_solver.h"

#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "elliptic/fold_count.h"
#include "elliptic/picard_iteration.h"
#include "elliptic/shapes.h"

namespace hexweave {
namespace {

bool same_bits(const Vec3& a, const Vec3& b) {
    using Bits = std::array<std::uint64_t, 3>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

bool is_finite(const PointField& points) {
    for (std::size_t p = 0; p < points.extent().nodes(); ++p) {
        if (!hexweave::is_finite(points[p])) return false;
    }
    return true;
}

/// Every boundary node of a and b has the same bits.
bool same_boundary(const PointField& a, const PointField& b) {
    const Extent e = a.extent();
    for (int k = 0; k < e.nk; ++k) {
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) {
                const bool inside = i > 0 && i < e.ni - 1 && j > 0 && j < e.nj - 1 &&
                                    (e.nk == 1 || (k > 0 && k < e.nk - 1));
                if (!inside && !same_bits(a(i, j, k), b(i, j, k))) return false;
            }
        }
    }
    return true;
}

}  // namespace

TEST_CASE("a solve that runs out of iterations says so and leaves finite points") {
    shapes::Problem problem = shapes::meander(65, 33, 1.5);
    const SolveResult result = solve_elliptic(problem.points, problem.parameters, {1e-3, 1});
    CHECK(result.status == SolveStatus::not_converged);
    CHECK(result.cycles == 1);
    CHECK(result.history.size() == 1);
    CHECK(result.displacement > 1e-3);
    CHECK(is_finite(problem.points));
}

TEST_CASE("of Picard steps, the grid with the fewest folded cells is the one that is kept") {
    const auto run = [](int steps) {
        shapes::Problem problem = shapes::meander(65, 33, 1.7);
        shapes::scatter(problem.points, {0, 0, 0}, {4, 2, 0});
        SolveResult result;
        BestIterate best(problem.points);
        iterate_picard(problem.points, problem.parameters, {1e-3, steps},
                       Safeguard::anderson_picard, result, best);
        CHECK(count_folded(problem.points) == best.rank.folded);
        CHECK(shapes::difference_in_cells(problem.points, best.points) == 0);
        return best;
    };
    const BestIterate start = run(1);
    CHECK(start.cycle == 0);
    const BestIterate after_4 = run(4);
    CHECK(after_4.rank < start.rank);
    // Two more steps fold more cells than they unfold.
    const BestIterate after_6 = run(6);
    CHECK(after_6.cycle == after_4.cycle);
    CHECK(shapes::difference_in_cells(after_6.points, after_4.points) == 0);
    CHECK(run(12).rank < after_4.rank);
}

TEST_CASE("what multigrid cannot do from a scattered start, the safeguards do") {
    shapes::Problem problem = shapes::meander(65, 33, 1.2);
    shapes::Problem plain = problem;
    shapes::scatter(problem.points, {0, 0, 0}, {4, 2, 0});
    const SolveResult result = solve_elliptic(problem.points, problem.parameters, {1e-6, 200});
    CHECK(result.status == SolveStatus::converged);
    CHECK(result.folded_before > 1000);
    CHECK(result.folded_after == 0);
    solve_elliptic(plain.points, plain.parameters, {1e-6, 200});
    CHECK(shapes::difference_in_cells(problem.points, plain.points) < 1e-5);
}

TEST_CASE("boundary nodes keep their bits") {
    shapes::Problem face = shapes::meander(33, 17, 1.2);
    face.points.set(0, 5, 0, {-0.0, face.points(0, 5).y, -0.0});
    const PointField face_start = face.points;
    solve_elliptic(face.points, face.parameters, {});
    CHECK(same_boundary(face.points, face_start));
    CHECK_FALSE(same_bits(face.points(7, 7), face_start(7, 7)));

    shapes::Problem block = shapes::wavy_cube(9);
    const PointField block_start = block.points;
    solve_elliptic(block.points, block.parameters, {});
    CHECK(same_boundary(block.points, block_start));
    CHECK_FALSE(same_bits(block.points(4, 3, 2), block_start(4, 3, 2)));
}

TEST_CASE("a grid without interior nodes is converged as it stands") {
    for (const Extent e : {Extent{2, 5, 1}, Extent{5, 2, 1}, Extent{5, 5, 2}, Extent{2, 5, 5}}) {
        const auto identity = [](double u, double v, double w) { return Vec3{u, v, w}; };
        PointField points = shapes::sample(e, identity);
        const PointField start = points;
        const SolveResult result =
            solve_elliptic(points, shapes::sample_parameters(e, identity), {});
        CHECK(result.status == SolveStatus::converged);
        CHECK(result.cycles == 0);
        CHECK(same_bits(points(1, 1, 0), start(1, 1, 0)));
    }
}

TEST_CASE("numbers out of range are told as divergence") {
    shapes::Problem problem = shapes::wavy_cube(5);
    problem.points.set(0, 2, 2, {std::numeric_limits<double>::infinity(), 0, 0});
    const PointField start = problem.points;
    const SolveResult result = solve_elliptic(problem.points, problem.parameters, {});
    CHECK(result.status == SolveStatus::diverged);
    CHECK(same_bits(problem.points(2, 2, 2), start(2, 2, 2)));
}

TEST_CASE("every status has a name of its own") {
    CHECK(status_name(SolveStatus::algebraic) == std::string("algebraic"));
    CHECK(status_name(SolveStatus::converged) == std::string("converged"));
    CHECK(status_name(SolveStatus::not_converged) == std::string("not converged"));
    CHECK(status_name(SolveStatus::diverged) == std::string("diverged"));
}

TEST_CASE("overhangs are unfolded from a folded start") {
    shapes::Problem problem = shapes::meander(129, 65, 1.7);
    const SolveResult result = solve_elliptic(problem.points, problem.parameters, {});
    CHECK(result.status == SolveStatus::converged);
    CHECK(result.folded_before > 1000);
    CHECK(result.folded_after == 0);
}

TEST_CASE("a wavy cube is unfolded from a folded start") {
    shapes::Problem problem = shapes::wavy_cube(17);
    shapes::fold(problem);
    const SolveResult result = solve_elliptic(problem.points, problem.parameters, {});
    CHECK(result.status == SolveStatus::converged);
    CHECK(result.folded_before > 1000);
    CHECK(result.folded_after == 0);
}

}  // namespace hexweave
