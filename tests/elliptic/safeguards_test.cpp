// SPDX-License-Identifier: Apache-2.0
// What is tried where multigrid cycles fail, and that it is told.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "elliptic/elliptic_solver.h"
#include "elliptic/fold_count.h"
#include "elliptic/picard_iteration.h"
#include "elliptic/poisson_equations.h"
#include "elliptic/shapes.h"

namespace hexweave {
namespace {

const std::vector<Safeguard> whole_chain{Safeguard::damping, Safeguard::anderson_picard,
                                         Safeguard::krylov_picard};

bool is_finite(const PointField& points) {
    for (std::size_t p = 0; p < points.extent().nodes(); ++p) {
        if (!hexweave::is_finite(points[p])) return false;
    }
    return true;
}

void check_result(const SolveResult& result) {
    CHECK(result.history.size() == static_cast<std::size_t>(result.cycles));
    CHECK(result.safeguards.size() <= whole_chain.size());
    CHECK(std::equal(result.safeguards.begin(), result.safeguards.end(), whole_chain.begin()));
}

/// Sheared products of clustered lines: points linear in the parameters.
shapes::Problem exact(const Extent& e, double offset) {
    const auto t = [](double v) { return std::expm1(5 * v) / std::expm1(5.0); };
    const auto sheared = [&](double u, double v, double w) {
        return Vec3{offset + u + 0.3 * t(v), t(v) - 0.2 * w, w + 0.1 * u};
    };
    const auto own = [&](double u, double v, double w) { return Vec3{u, t(v), w}; };
    return {shapes::sample(e, sheared), shapes::sample_parameters(e, own)};
}

void move(PointField& points, double by) {
    for (std::size_t p = 0; p < points.extent().nodes(); ++p) points.x[p] += by;
}

}  // namespace

TEST_CASE("both kinds of Picard steps end at the grid of the cycles") {
    for (const shapes::Problem& problem : {shapes::meander(65, 33, 1.7), shapes::wavy_cube(9)}) {
        PointField expected = problem.points;
        REQUIRE(solve_elliptic(expected, problem.parameters, {1e-6, 200}).status ==
                SolveStatus::converged);
        for (const Safeguard kind : {Safeguard::anderson_picard, Safeguard::krylov_picard}) {
            PointField points = problem.points;
            SolveResult result;
            BestIterate best(points);
            iterate_picard(points, problem.parameters, {1e-6, 200}, kind, result, best);
            CHECK(result.status == SolveStatus::converged);
            CHECK(result.history.size() == static_cast<std::size_t>(result.cycles));
            CHECK(shapes::difference_in_cells(points, expected) < 1e-5);
        }
    }
}

TEST_CASE("Picard steps from the solution itself end at once, though it is not exact") {
    for (const Extent e : {Extent{3, 3, 1}, Extent{4, 7, 1}, Extent{3, 4, 5}}) {
        for (const double offset : {0.0, 1e3}) {
            for (const Safeguard kind : {Safeguard::anderson_picard, Safeguard::krylov_picard}) {
                shapes::Problem problem = exact(e, offset);
                SolveResult result;
                BestIterate best(problem.points);
                iterate_picard(problem.points, problem.parameters, {1e-8, 50}, kind, result, best);
                CHECK(result.status == SolveStatus::converged);
                CHECK(result.cycles <= 2);
            }
        }
    }
}

TEST_CASE("overhangs that undo the usual cycles are reached by relaxed ones or steps") {
    // 2.1 radians: the boundary nearly touches itself. Whatever happens must be told in order.
    for (const bool scattered : {false, true}) {
        shapes::Problem problem = shapes::meander(65, 33, 2.1);
        if (scattered) shapes::scatter(problem.points, {0, 0, 0}, {4, 2, 0});
        const SolveResult result = solve_elliptic(problem.points, problem.parameters, {1e-4, 200});
        check_result(result);
        CHECK_FALSE(result.safeguards.empty());
        CHECK(is_finite(problem.points));
        CHECK(result.status == SolveStatus::converged);
        CHECK(shapes::largest_unfulfilled(problem.points, problem.parameters) < 1e-4);
    }
}

TEST_CASE("where nothing helps all safeguards are told, and the points are finite") {
    // Numbers whose products overflow.
    shapes::Problem problem = shapes::wavy_cube(9);
    for (std::size_t p = 0; p < problem.points.extent().nodes(); ++p) {
        problem.points.set(p, 1e150 * problem.points[p]);
    }
    const SolveResult result = solve_elliptic(problem.points, problem.parameters, {1e-3, 50});
    check_result(result);
    CHECK(result.status == SolveStatus::diverged);
    CHECK(result.kept_cycle == 0);
    CHECK(result.safeguards == whole_chain);
    CHECK(is_finite(problem.points));
}

TEST_CASE("too few cycles do not set off safeguards that were not asked to wait for") {
    shapes::Problem problem = shapes::meander(65, 33, 1.7);
    const SolveResult result = solve_elliptic(problem.points, problem.parameters, {1e-6, 3});
    CHECK(result.status == SolveStatus::not_converged);
    CHECK(result.cycles == 3);
    CHECK(result.safeguards.empty());
    CHECK(is_finite(problem.points));
}

TEST_CASE("of cycles that run out the grid with the fewest folded cells is kept, never a worse") {
    const auto run = [](int cycles, PointField& points) {
        shapes::Problem problem = shapes::meander(65, 33, 1.9);
        shapes::scatter(problem.points, {0, 0, 0}, {4, 2, 0});
        const SolveResult result =
            solve_elliptic(problem.points, problem.parameters, {1e-6, cycles});
        CHECK(result.status == SolveStatus::not_converged);
        CHECK(result.folded_after == count_folded(problem.points));
        points = problem.points;
        return result;
    };
    PointField kept;
    SolveResult before = run(0, kept);
    CHECK(before.kept_cycle == 0);
    CHECK(before.folded_after == before.folded_before);
    for (int cycles = 1; cycles <= 6; ++cycles) {
        const PointField kept_before = kept;
        const SolveResult result = run(cycles, kept);
        REQUIRE(result.kept_cycle);
        CHECK(result.folded_after <= before.folded_after);
        // Either the last cycle brought a better grid, or that of fewer cycles stands.
        if (*result.kept_cycle < cycles) {
            CHECK(result.kept_cycle == before.kept_cycle);
            CHECK(shapes::difference_in_cells(kept, kept_before) == 0);
        }
        before = result;
    }
    CHECK(*before.kept_cycle < 6);
}

TEST_CASE("a sound start grid stands where a few cycles fold it") {
    // The wall turns by 1.5 radians within four cells: on the way to the solution cells fold.
    const shapes::Problem start = shapes::meander(17, 9, 1.5);
    REQUIRE(count_folded(start.points) == 0);
    PointField points = start.points;
    const SolveResult result = solve_elliptic(points, start.parameters, {1e-6, 3});
    CHECK(result.status == SolveStatus::not_converged);
    CHECK(result.kept_cycle == 0);
    CHECK(result.cycles == 3);
    CHECK(result.folded_after == 0);
    CHECK(shapes::difference_in_cells(points, start.points) == 0);
}

TEST_CASE("a tolerance beyond what the digits of coordinates allow does not make a solve fail") {
    // First cells of 1e-8, a thousand units away from the origin: a unit in the last place of the
    // coordinates is 1e-5 of a cell.
    shapes::Problem problem = shapes::clustered_block({9, 9, 25}, 1e-8);
    move(problem.points, 1e3);
    const SolveResult result = solve_elliptic(problem.points, problem.parameters, {1e-8, 200});
    CHECK(result.status == SolveStatus::converged);
    CHECK(result.safeguards.empty());
    CHECK(result.cycles < 30);
    CHECK(result.displacement > 1e-8);
    // Where the digits do allow it, it is reached.
    shapes::Problem near = shapes::clustered_block({9, 9, 25}, 1e-6);
    const SolveResult result_near = solve_elliptic(near.points, near.parameters, {1e-8, 200});
    CHECK(result_near.status == SolveStatus::converged);
    CHECK(result_near.displacement < 1e-8);
}

TEST_CASE("cycles to 1e-4 of a cell do not grow with the grid") {
    const auto cycles = [](shapes::Problem problem) {
        const SolveResult result = solve_elliptic(problem.points, problem.parameters, {1e-4, 200});
        CHECK(result.status == SolveStatus::converged);
        CHECK(result.safeguards.empty());
        return result.cycles;
    };
    for (const int m : {1, 2, 4}) {
        CHECK(cycles(shapes::ring(64 * m + 1, 32 * m + 1, 1e-5)) <= 10);
        CHECK(cycles(shapes::meander(64 * m + 1, 32 * m + 1, 1.7)) <= 10);
        CHECK(cycles(shapes::clustered_saddle(64 * m + 1, 32 * m + 1, 1e-6)) <= 10);
    }
    for (const int m : {1, 2, 3}) {
        CHECK(cycles(shapes::clustered_block({12 * m + 1, 12 * m + 1, 16 * m + 1}, 1e-5)) <= 10);
        CHECK(cycles(shapes::wavy_cube(12 * m + 1)) <= 10);
    }
}

}  // namespace hexweave
