// SPDX-License-Identifier: Apache-2.0
// Displacements in cells, and when a series of them is at its end.
#include "elliptic/displacement.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "elliptic/convergence.h"
#include "elliptic/levels.h"
#include "elliptic/shapes.h"

namespace hexweave {
namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

/// The displacement in cells of node (i, j, k) alone, by d.
double cells_of(const Level& level, int i, int j, int k, const Vec3& d) {
    RowArray<float> moved(level.extent, level.components);
    shapes::at(moved, level, i, j, k, 0) = static_cast<float>(d.x);
    shapes::at(moved, level, i, j, k, 1) = static_cast<float>(d.y);
    if (level.components == 3) shapes::at(moved, level, i, j, k, 2) = static_cast<float>(d.z);
    return largest_displacement(level, moved);
}

Level sheared(const Extent& e, int components) {
    const auto map = [&](double u, double v, double w) {
        // Cells (0.1, 0, 0), (0.5, 0.2, 0) and (0, 0, 0.4) wide.
        return Vec3{0.1 * u * (e.ni - 1) + 0.5 * v * (e.nj - 1), 0.2 * v * (e.nj - 1),
                    0.4 * w * (e.nk - 1)};
    };
    return shapes::level_of(shapes::sample(e, map), shapes::sample_parameters(e, map), components);
}

}  // namespace

TEST_CASE("a displacement along a grid line counts in cells of that line") {
    for (const int components : {2, 3}) {
        const Level face = sheared({9, 6, 1}, components);
        CHECK(cells_of(face, 3, 2, 0, {0.05, 0, 0}) == Approx(0.5));
        CHECK(cells_of(face, 7, 4, 0, {-0.25, -0.1, 0}) == Approx(0.5));
        // Across the lines along i: a fifth of the cells' height, and back along them by 2.5 cells.
        CHECK(cells_of(face, 4, 3, 0, {0, 0.04, 0}) == Approx(1));
    }
    const Level block = sheared({9, 6, 5}, 3);
    CHECK(cells_of(block, 1, 1, 1, {0.05, 0, 0}) == Approx(0.5));
    CHECK(cells_of(block, 7, 4, 3, {0.5, 0.2, 0}) == Approx(1));
    CHECK(cells_of(block, 4, 3, 2, {0, 0, -0.8}) == Approx(2));
}

TEST_CASE("what leaves a face counts against the square root of its cell's area") {
    const Level face = sheared({9, 6, 1}, 3);
    CHECK(cells_of(face, 3, 2, 0, {0, 0, 0.1}) == Approx(0.1 / std::sqrt(0.1 * 0.2)));
}

TEST_CASE("the largest displacement of all nodes is told, and none is none") {
    const Level block = sheared({18, 7, 5}, 3);
    RowArray<float> moved(block.extent, 3);
    CHECK(largest_displacement(block, moved) == 0);
    shapes::for_inside(block, [&](int i, int j, int k) {
        shapes::at(moved, block, i, j, k) = i == 16 && j == 5 && k == 3 ? 0.3F : 0.1F;
    });
    CHECK(largest_displacement(block, moved) == Approx(3));
}

TEST_CASE("numbers that are none are told, wherever they are") {
    for (const Extent e : {Extent{18, 7, 1}, Extent{7, 18, 5}}) {
        const Level level = sheared(e, 3);
        shapes::for_inside(level, [&](int i, int j, int k) {
            for (const float bad : {nan_value, infinite, -infinite}) {
                RowArray<float> moved(e, 3);
                shapes::at(moved, level, i, j, k, (i + j) % 3) = bad;
                CHECK_FALSE(largest_displacement(level, moved) < 1e300);
            }
        });
    }
}

TEST_CASE("a collapsed cell does not make displacements infinite") {
    Level level = sheared({5, 5, 1}, 2);
    // All neighbours of (2, 2) on one line, and then in one point.
    for (const double width : {0.1, 0.0}) {
        shapes::for_inside(level, [&](int i, int j, int k) {
            shapes::at(level.points, level, i, j, k, 0) = width * (i + j);
            shapes::at(level.points, level, i, j, k, 1) = 0;
        });
        CHECK(cells_of(level, 2, 2, 0, {1, 1, 0}) < 1e5);
    }
}

TEST_CASE("the rate of a series is its worst of the last two steps, within bounds") {
    CHECK(convergence_rate({}) == 0.9);
    CHECK(convergence_rate({1}) == 0.9);
    CHECK(convergence_rate({1, 0.5}) == Approx(0.5));
    CHECK(convergence_rate({1, 0.01}) == Approx(0.3));  // from the start grid: not to be believed
    CHECK(convergence_rate({1, 0.2, 0.04}) == Approx(0.2));
    CHECK(convergence_rate({1, 0.9, 0.09}) == Approx(0.3));
    CHECK(convergence_rate({1, 0.1, 0.05}) == Approx(0.5));
    CHECK(convergence_rate({1, 1e-3, 1e-6}) == Approx(0.1));
    CHECK(convergence_rate({1, 2, 4}) == Approx(0.99));
}

TEST_CASE("convergence takes what is still to come into account") {
    CHECK_FALSE(has_converged({}, 1e-3));
    CHECK(has_converged({0}, 1e-3));
    CHECK(has_converged({1e-4}, 1e-3));
    CHECK_FALSE(has_converged({2e-4}, 1e-3));                  // 9 times as much may follow
    CHECK(has_converged({1e-2, 3e-3, 9e-4}, 1e-3));            // 4e-4 is left
    CHECK_FALSE(has_converged({2e-3, 1.4e-3, 9.8e-4}, 1e-3));  // 2.3e-3 is left
    CHECK_FALSE(has_converged({1e-8, 1e-5, 2e-3}, 1e-3));
    CHECK_FALSE(has_converged({std::numeric_limits<double>::quiet_NaN()}, 1e-3));
}

}  // namespace hexweave
