// SPDX-License-Identifier: Apache-2.0
// The problems are those of the study, and what measures the solvers is right.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "bench/block_from_sides.h"
#include "bench/measures.h"
#include "bench/problems.h"
#include "bench/timed_run.h"
#include "bench/wing_blocks.h"
#include "bench/yardsticks/picard.h"
#include "bench/yardsticks/slor.h"

#ifdef HEXWEAVE_BENCH_HYPRE
#include "bench/yardsticks/hypre_picard.h"
#endif

using namespace hexweave;
using namespace hexweave::bench;

namespace {

constexpr double pi = std::numbers::pi;

/// A quarter of an annulus between radii 1 and 3, one high, at parameters that lean and grow. Its
/// parameters log r / log 3, angle and height are harmonic: it solves the equations exactly.
Problem annulus(const Extent& e) {
    Problem problem{"annulus", PointField(e), {Field(e), Field(e), Field(e)}};
    for (int k = 0; k < e.nk; ++k) {
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) {
                const double xi = static_cast<double>(i) / (e.ni - 1);
                const double eta = static_cast<double>(j) / (e.nj - 1);
                const double zeta = e.nk == 1 ? 0 : static_cast<double>(k) / (e.nk - 1);
                const double bump = std::sin(pi * xi) * std::sin(pi * eta);
                const double s = xi + 0.08 * std::sin(pi * xi) * std::cos(2 * eta + zeta);
                const double t = eta * (1 + eta) / 2 + 0.05 * bump;
                const double u = zeta + 0.06 * std::sin(pi * zeta) * (1 + bump);
                const double radius = std::pow(3, s);
                problem.points.set(
                    i, j, k,
                    {radius * std::cos(pi / 2 * (1 - t)), radius * std::sin(pi / 2 * (1 - t)), -u});
                problem.parameters.s(i, j, k) = s;
                problem.parameters.t(i, j, k) = t;
                problem.parameters.u(i, j, k) = u;
            }
        }
    }
    return problem;
}

double annulus_residual(int n, bool block) {
    const Problem problem = annulus({n, n, block ? n : 1});
    return residual_in_cells(problem.points, problem.parameters);
}

}  // namespace

TEST_CASE("points linear in the parameters leave no residual") {
    Problem problem = annulus({17, 13, 9});
    for (std::size_t p = 0; p < problem.points.extent().nodes(); ++p) {
        const Vec3 s{problem.parameters.s[p], problem.parameters.t[p], problem.parameters.u[p]};
        problem.points.set(p, {2 * s.x + s.y, s.y - 3 * s.z, s.x + 5 * s.z});
    }
    CHECK(residual_in_cells(problem.points, problem.parameters) < 1e-12);
    problem.points.set(5, 5, 5, problem.points(5, 5, 5) + Vec3{1e-3, 0, 0});
    CHECK(residual_in_cells(problem.points, problem.parameters) > 1e-4);
}

TEST_CASE("the residual of an exact map falls with the cube of the cell, in cells") {
    // Second order relative to derivatives of the points; a cell is one order more.
    for (const bool block : {false, true}) {
        const double coarse = annulus_residual(17, block);
        const double fine = annulus_residual(33, block);
        CHECK(std::log2(coarse / fine) == Approx(3).margin(0.35));
    }
}

TEST_CASE("an error is measured along the cell that a point was moved across") {
    PointField grid(Extent{5, 5, 5});
    for (int k = 0; k < 5; ++k) {
        for (int j = 0; j < 5; ++j) {
            for (int i = 0; i < 5; ++i) grid.set(i, j, k, {0.5 * i, 2.0 * j, 1e-3 * k});
        }
    }
    PointField moved = grid;
    moved.set(2, 2, 2, grid(2, 2, 2) + Vec3{0.05, 0.1, 4e-4});
    CHECK(error_in_cells(moved, grid) == Approx(0.4));
    moved.set(2, 2, 2, {std::nan(""), 0, 0});
    CHECK(std::isnan(error_in_cells(moved, grid)));
}

TEST_CASE("problems are drawn as in the study") {
    const auto a = make_problem("A", {129, 65, 1});
    REQUIRE(a);
    CHECK(a->points(0, 0) == Vec3{1, 0, 0});
    CHECK(a->points(128, 0) == Vec3{0, 0, 0});
    CHECK(distance(a->points(0, 0), a->points(0, 1)) == Approx(1e-5));
    CHECK(distance(a->points(128, 64), {-19.5, 0, 0}) < 1e-12);
    CHECK(grid_quality(a->points).folded == 0);

    const auto c = make_problem("C", {33, 33, 33}, {Start::folded});
    REQUIRE(c);
    CHECK(grid_quality(c->points).folded == 9883);
    const auto b19 = make_problem("B19", {129, 65, 1});
    REQUIRE(b19);
    CHECK(grid_quality(b19->points).folded == 2304);

    const auto oo = make_problem("OO", {17, 17, 17});
    REQUIRE(oo);
    for (int k = 0; k < 17; ++k) {
        for (int n = 0; n < 17; ++n) {
            CHECK(oo->points(0, n, k).z == 0);
            CHECK(oo->points(16, n, k).z == 0);
            CHECK(oo->points(n, 16, k).z == 0);
        }
    }
    CHECK(distance(oo->points(8, 8, 16), {0.5, 0, 0}) == Approx(10));
    CHECK(!make_problem("A", {9, 9, 9}));
    CHECK(!make_problem("B11", {9, 9, 1}));
}

TEST_CASE("wing and wake blocks hold the same points on the face between them") {
    const WingGrid grid{13, 1e-4, 1e-2, Tip::revolved, 10, 1};
    const auto wing = wing_block(grid);
    const auto wake = wake_block(grid);
    REQUIRE((wing && wake));
    CHECK(grid_quality(wing->points).folded == 0);
    CHECK(grid_quality(wake->points).folded == 0);
    for (int k = 0; k < 13; ++k) {
        for (int j = 0; j < 13; ++j) {
            CHECK(distance(wing->points(12, j, k), wake->points(0, j, k)) < 1e-9);
        }
    }
}

TEST_CASE("every yardstick arrives at the program's own grid") {
#ifdef HEXWEAVE_BENCH_HYPRE
    const HypreSession session;
    std::vector<Yardstick> yardsticks = hypre_yardsticks();
#else
    std::vector<Yardstick> yardsticks;
#endif
    yardsticks.push_back(ilu_picard());
    yardsticks.push_back(line_relaxation(1.5));
    for (const auto& [name, extent] :
         {std::pair{"A", Extent{33, 17, 1}}, std::pair{"Scherk", Extent{17, 21, 1}},
          std::pair{"W", Extent{13, 11, 15}}}) {
        const auto problem = make_problem(name, extent);
        REQUIRE(problem);
        const Reference reference = converged_grid(*problem);
        CHECK(reference.trusted());
        for (const Yardstick& yardstick : yardsticks) {
            INFO(name << ", " << yardstick.name);
            const MethodRun run = time_yardstick(*problem, reference.points, yardstick, 20);
            CHECK(run.to_coarse);
            CHECK(run.to_fine);
        }
    }
}
