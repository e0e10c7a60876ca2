// SPDX-License-Identifier: Apache-2.0
// Untangling: what it cures, what it leaves alone, and what it says when there is no cure.
#include "elliptic/untangle.h"

#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "core/parallel.h"
#include "elliptic/fold_count.h"
#include "elliptic/foldover_functional.h"
#include "elliptic/lattice_runs.h"
#include "elliptic/shapes.h"
#include "elliptic/target_cells.h"
#include "elliptic/unfold.h"
#include "elliptic/untangle_patch.h"

namespace hexweave {
namespace {

bool same_bits(const Vec3& a, const Vec3& b) {
    using Bits = std::array<std::uint64_t, 3>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

long count_different(const PointField& a, const PointField& b) {
    long different = 0;
    for (std::size_t p = 0; p < a.extent().nodes(); ++p) different += !same_bits(a[p], b[p]);
    return different;
}

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

/// A boundary layer on a waved wall, with a column of nodes pushed over its neighbours.
PointField folded_layer() {
    PointField points = shapes::sample({25, 21, 17}, [](double xi, double eta, double zeta) {
        const double height = 1e-3 * zeta + zeta * zeta * zeta;
        return Vec3{xi, eta, height + 0.05 * std::sin(6 * xi) * std::cos(5 * eta)};
    });
    for (int k = 1; k < 8; ++k) {
        points.set(12, 10, k, points(12, 10, k) + Vec3{0.06, 0.02, 0});
    }
    return points;
}

PointField no_transfinite() {
    FAIL("the transfinite grid is not needed here");
    return {};
}

}  // namespace

TEST_CASE("a sound grid is left alone") {
    PointField points = shapes::sample({6, 5, 4}, shapes::leaning);
    const PointField before = points;
    CHECK_FALSE(untangle(points, no_transfinite).has_value());
    CHECK(count_different(points, before) == 0);
}

TEST_CASE("folded columns are unfolded in a small patch") {
    PointField points = folded_layer();
    const PointField before = points;
    const auto result = untangle(points, no_transfinite);
    REQUIRE(result.has_value());
    CHECK(result->folded_before == count_folded(before));
    CHECK(result->folded_before > 0);
    CHECK(count_folded(points) == 0);
    CHECK(result->patches == 1);
    CHECK_FALSE(result->whole_grid);
    CHECK(result->points_moved == count_different(points, before));
    CHECK(result->points_moved < 700);
    CHECK(same_boundary(points, before));
    CHECK(same_bits(points(20, 10, 3), before(20, 10, 3)));
    double largest = 0;
    for (std::size_t p = 0; p < points.extent().nodes(); ++p) {
        largest = std::max(largest, distance(points[p], before[p]));
    }
    CHECK(result->largest_move == largest);
    CHECK(distance(result->place, before(12, 10, 4)) < 0.1);
}

TEST_CASE("patches that touch become one, others stay apart") {
    PointField points = folded_layer();
    for (int k = 1; k < 8; ++k) points.set(3, 4, k, points(3, 4, k) + Vec3{0.06, 0.02, 0});
    const auto apart = untangle(points, no_transfinite);
    REQUIRE(apart.has_value());
    CHECK(apart->patches == 2);
    CHECK(count_folded(points) == 0);
    points = folded_layer();
    for (int k = 1; k < 8; ++k) points.set(14, 12, k, points(14, 12, k) + Vec3{0.06, 0.02, 0});
    const auto joined = untangle(points, no_transfinite);
    REQUIRE(joined.has_value());
    CHECK(joined->patches == 1);
    CHECK(count_folded(points) == 0);
}

TEST_CASE("the result is the same for any number of threads") {
    const int threads_before = threads();
    std::vector<PointField> results;
    for (const int count : {1, 2, 4}) {
        set_threads(count);
        PointField points = folded_layer();
        for (int k = 1; k < 8; ++k) points.set(3, 4, k, points(3, 4, k) + Vec3{0.06, 0.02, 0});
        untangle(points, no_transfinite);
        results.push_back(points);
    }
    set_threads(threads_before);
    CHECK(count_different(results[0], results[1]) == 0);
    CHECK(count_different(results[0], results[2]) == 0);
}

TEST_CASE("a mirrored grid gives the mirrored result") {
    PointField points = folded_layer();
    const Extent e = points.extent();
    PointField mirrored(e);
    const auto mirror = [&](const PointField& from, PointField& to) {
        for (int k = 0; k < e.nk; ++k) {
            for (int j = 0; j < e.nj; ++j) {
                for (int i = 0; i < e.ni; ++i) {
                    const Vec3 p = from(e.ni - 1 - i, j, k);
                    to.set(i, j, k, {-p.x, p.y, p.z});
                }
            }
        }
    };
    mirror(points, mirrored);
    untangle(points, no_transfinite);
    untangle(mirrored, no_transfinite);
    PointField back(e);
    mirror(mirrored, back);
    double largest = 0;
    for (std::size_t p = 0; p < e.nodes(); ++p) {
        largest = std::max(largest, distance(points[p], back[p]));
    }
    CHECK(largest < 1e-9);
}

TEST_CASE("overhangs of 1.9 radians are unfolded from the transfinite grid") {
    for (const double angle : {1.7, 1.9}) {
        shapes::Problem problem = shapes::meander(65, 33, angle);
        const PointField start = problem.points;
        REQUIRE(count_folded(start) > 300);
        const auto result = untangle(problem.points, [&] { return start; });
        REQUIRE(result.has_value());
        CHECK(result->whole_grid);
        CHECK(count_folded(problem.points) == 0);
        CHECK(same_boundary(problem.points, start));
        for (std::size_t p = 0; p < start.extent().nodes(); ++p) {
            REQUIRE(problem.points.z[p] == 0);
        }
    }
}

TEST_CASE("boxes of the boundary's sizes are an aim where cells say nothing") {
    const shapes::Problem problem = shapes::meander(65, 33, 1.9);
    Runs free;
    for (int j = 1; j < 32; ++j) free.push_back({0, j, 1, 63});
    Patch patch = make_patch(problem.points, free, 1, plane_normal(problem.points));
    aim_at_boxes(patch, problem.points);
    REQUIRE(count_folded(patch) > 300);
    CHECK(unfold(patch, {0.5, 100, 2, 1e7}).folded == 0);
    CHECK(count_folded(patch) == 0);
    // On a rectangle with straight graded lines they are its cells: nothing pulls.
    const PointField graded = shapes::sample({9, 7, 5}, [](double xi, double eta, double zeta) {
        return Vec3{xi * xi + xi, 2 * eta, zeta * zeta * zeta};
    });
    Runs inside;
    for (int k = 1; k < 4; ++k) {
        for (int j = 1; j < 6; ++j) inside.push_back({k, j, 1, 7});
    }
    Patch boxes = make_patch(graded, inside, 2, {});
    aim_at_boxes(boxes, graded);
    const auto corners = static_cast<double>(boxes.targets.size());
    CHECK(evaluate(boxes, 1e-9).energy <= 4 * corners * (1 + 1e-12));
    unfold(boxes, {});
    for (std::size_t n = 0; n < boxes.nodes.size(); ++n) {
        CHECK(distance(boxes.points[n], graded[boxes.nodes[n]]) < 1e-12);
    }
}

TEST_CASE("a wavy cube is unfolded from a heavily folded start") {
    shapes::Problem problem = shapes::wavy_cube(13);
    const PointField transfinite = problem.points;
    shapes::fold(problem);
    REQUIRE(count_folded(problem.points) > 500);
    const auto result = untangle(problem.points, [&] { return transfinite; });
    REQUIRE(result.has_value());
    CHECK(count_folded(problem.points) == 0);
    CHECK(same_boundary(problem.points, transfinite));
}

TEST_CASE("a face of either sense, and one in space, are unfolded near their surface") {
    PointField clockwise = shapes::sample({17, 15, 1}, [](double xi, double eta, double) {
        return Vec3{eta, xi, 2};
    });
    clockwise.set(8, 7, 0, clockwise(8, 7) + Vec3{0.1, 0.1, 0});
    REQUIRE(count_folded(clockwise) > 0);
    CHECK(untangle(clockwise, no_transfinite)->patches == 1);
    CHECK(count_folded(clockwise) == 0);
    CHECK(clockwise(8, 7).z == 2);

    // A helicoid, which is a minimal surface: x sin(z) = y cos(z).
    PointField helicoid = shapes::sample({17, 15, 1}, [](double xi, double eta, double) {
        return Vec3{(1 + xi) * std::cos(eta), (1 + xi) * std::sin(eta), eta};
    });
    helicoid.set(8, 7, 0, helicoid(8, 5));
    REQUIRE(count_folded(helicoid) > 0);
    CHECK(untangle(helicoid, no_transfinite)->patches == 1);
    CHECK(count_folded(helicoid) == 0);
    for (std::size_t p = 0; p < helicoid.extent().nodes(); ++p) {
        const Vec3 x = helicoid[p];
        CHECK(std::abs(x.x * std::sin(x.z) - x.y * std::cos(x.z)) < 2e-3);
    }
}

TEST_CASE("what the boundary folds is left, and told") {
    const auto identity = [](double u, double v, double w) { return Vec3{u, v, w}; };
    PointField points = shapes::sample({8, 8, 8}, identity);
    // A vertex pushed through the cell: all nodes of its corner are on the boundary.
    points.set(0, 0, 0, {0.2, 0.2, 0.2});
    const PointField before = points;
    REQUIRE(count_folded(before) == 1);
    const auto result = untangle(points, no_transfinite);
    REQUIRE(result.has_value());
    CHECK(result->folded_before == 1);
    CHECK(result->points_moved == 0);
    CHECK(result->left_at == before(0, 0, 0));
    CHECK(count_different(points, before) == 0);
}

TEST_CASE("where there is no cure the grid is no worse than before") {
    // The upper side of the square dips below the lower one.
    PointField points = shapes::sample({13, 9, 1}, [](double xi, double eta, double) {
        return Vec3{xi, eta * (1 - 4.8 * xi * (1 - xi)), 0};
    });
    const PointField before = points;
    const long folded = count_folded(before);
    REQUIRE(folded > 0);
    const auto result = untangle(points, [&] { return before; });
    REQUIRE(result.has_value());
    CHECK(result->folded_before == folded);
    CHECK(count_folded(points) > 0);
    CHECK(count_folded(points) <= folded);
    CHECK(result->left_at.has_value());
    CHECK(same_boundary(points, before));
}

TEST_CASE("runs grow, merge and fall into connected parts") {
    const Runs runs = merged({{0, 0, 4, 6}, {0, 0, 1, 3}, {0, 2, 1, 1}, {0, 0, 9, 9}});
    CHECK(runs == Runs{{0, 0, 1, 6}, {0, 0, 9, 9}, {0, 2, 1, 1}});
    CHECK(connected_parts(runs).size() == 3);
    const Runs wide = grown(runs, {{0, 0, 0}, {1, 1, 0}}, {0, 0, 0}, {9, 9, 0});
    CHECK(wide ==
          Runs{{0, 0, 1, 7}, {0, 0, 9, 9}, {0, 1, 1, 7}, {0, 1, 9, 9}, {0, 2, 1, 2}, {0, 3, 1, 2}});
    CHECK(connected_parts(wide).size() == 2);
    CHECK(count_members(wide) == 20);
    CHECK(find_run(wide, 5, 1, 0) == 2);
}

}  // namespace hexweave
