// SPDX-License-Identifier: Apache-2.0
// Angles, growth and first cells of grids of which they are known.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "quality/angles.h"
#include "quality/growth.h"
#include "quality/walls.h"

using namespace hexweave;

namespace {

const double pi = std::acos(-1.0);

PointField sampled(Extent extent, const std::function<Vec3(double, double, double)>& map) {
    PointField points(extent);
    for (int k = 0; k < extent.nk; ++k)
        for (int j = 0; j < extent.nj; ++j)
            for (int i = 0; i < extent.ni; ++i) points.set(i, j, k, map(i, j, k));
    return points;
}

/// Parallelograms of one angle, 1000 times as long as high.
std::function<Vec3(double, double, double)> sheared(double degrees) {
    const double angle = degrees * pi / 180;
    return [angle](double i, double j, double k) {
        return Vec3{i + 1e-3 * j * std::cos(angle), 1e-3 * j * std::sin(angle), k};
    };
}

/// Half an annulus: j outwards in intervals that grow by a factor, lines that lean off the radius
/// by an angle at the inner circle.
PointField half_annulus(int ni, int nj, double growth, double lean) {
    return sampled({ni + 1, nj + 1, 1}, [=](double i, double j, double) {
        const double off = 0.01 * (std::pow(growth, j) - 1) / (growth - 1);
        const double angle = pi * (1 - i / ni);
        const double slope = lean * pi / 180;
        const Vec3 radial{std::cos(angle), std::sin(angle), 0};
        const Vec3 around{-std::sin(angle), std::cos(angle), 0};
        return radial + off * (std::cos(slope) * radial + std::sin(slope) * around);
    });
}

MultiblockGrid with_wall(PointField points, const IndexBox& wall) {
    MultiblockGrid grid;
    grid.zones.push_back({"zone", std::move(points)});
    grid.families = {{"outside", "BCFarfield"}, {"body", "BCWallViscous"}};
    grid.patches.push_back({"edge", 0, wall, 1});
    return grid;
}

}  // namespace

TEST_CASE("corner angles of parallelograms are the shear and its supplement") {
    const AngleMeasure m = measure_angles(sampled({5, 4, 1}, sheared(83)));
    CHECK(m.corners == 4 * 12);
    CHECK(m.least == Approx(83).epsilon(1e-10));
    CHECK(m.greatest == Approx(97).epsilon(1e-10));
    CHECK(m.within_5 == 0);
    CHECK(m.within_10 == m.corners);
}

TEST_CASE("a block's cells have twenty-four angles each, those of sheared ones in one plane") {
    const AngleMeasure m = measure_angles(sampled({3, 4, 5}, sheared(60)));
    CHECK(m.corners == 24 * 2 * 3 * 4);
    CHECK(m.within_5 == 16 * 2 * 3 * 4);
    CHECK(m.least == Approx(60).epsilon(1e-10));
}

TEST_CASE("the worst corner is found at its place, and angles of zones add up") {
    PointField points = sampled({6, 6, 1}, sheared(90));
    points.set(3, 2, 0, {3.3, 2e-3, 0});
    AngleMeasure m = measure_angles(points);
    CHECK(m.least < 1);
    CHECK(std::abs(m.worst_place().x - 3) < 0.5);
    const AngleMeasure other = measure_angles(sampled({3, 3, 1}, sheared(60)));
    const std::size_t corners = m.corners;
    m.include(other);
    CHECK(m.corners == corners + 16);
    CHECK(m.worst_place().x > 2);
    AngleMeasure worse = other;
    worse.include(measure_angles(points));
    CHECK(worse.worst_place().x == m.worst_place().x);
    CHECK(worse.least == m.least);
}

TEST_CASE("corners at a pole have no angle") {
    const AngleMeasure m = measure_angles(sampled({4, 3, 1}, [](double i, double j, double) {
        return Vec3{i * j, j, 0};
    }));
    CHECK(m.corners == 4 * 6 - 6);
    CHECK(std::isfinite(m.least));
}

TEST_CASE("growth is that of the intervals along each axis, whichever way they grow") {
    const PointField x = sampled({6, 7, 5}, [](double i, double j, double k) {
        return Vec3{std::pow(1.2, i), -std::pow(0.7, j), 3 * k};
    });
    const auto growth = measure_growth(x);
    CHECK(growth[0].ratio == Approx(1.2).epsilon(1e-12));
    CHECK(growth[1].ratio == Approx(1 / 0.7).epsilon(1e-12));
    CHECK(growth[2].ratio == Approx(1).epsilon(1e-12));
}

TEST_CASE("growth is found at its place, and a pole has none") {
    PointField x = sampled({6, 4, 1}, [](double i, double j, double) { return Vec3{i, j, 0}; });
    x.set(3, 2, 0, {3.25, 2, 0});
    const auto growth = measure_growth(x);
    CHECK(growth[0].ratio == Approx(1.25 / 0.75));
    CHECK(growth[0].place == Vec3{3.25, 2, 0});
    const auto at_pole = measure_growth(sampled({4, 3, 1}, [](double i, double j, double) {
        return Vec3{i * j, j, 0};
    }));
    CHECK(at_pole[0].ratio == Approx(1).epsilon(1e-12));
}

TEST_CASE("growth across an interface compares the intervals on its two sides") {
    MultiblockGrid grid;
    // The second zone runs down from the first one's lower side, its i along the first's -j.
    grid.zones.push_back({"upper", sampled({4, 3, 1}, [](double i, double j, double) {
                              return Vec3{i, 0.5 * j, 0};
                          })});
    grid.zones.push_back({"lower", sampled({3, 4, 1}, [](double i, double j, double) {
                              return Vec3{j, -0.2 * i, 0};
                          })});
    grid.interfaces.push_back(
        {"cut", 0, {{0, 0, 0}, {3, 0, 0}}, 1, {{0, 0, 0}, {0, 3, 0}}, Orientation{{2, -1, 3}}});
    CHECK(measure_growth(grid, grid.interfaces[0]).ratio == Approx(2.5));
}

TEST_CASE("lines that lean off the radius of a circle lean so much off its normal") {
    for (const double lean : {0.0, 7.0}) {
        const auto walls =
            measure_walls(with_wall(half_annulus(40, 8, 1.3, lean), {{0, 0, 0}, {40, 0, 0}}));
        REQUIRE(walls.size() == 1);
        CHECK(walls[0].family == "body");
        CHECK(walls[0].nodes == 37);
        CHECK(walls[0].mean_angle == Approx(lean).margin(1e-9));
        CHECK(walls[0].greatest_angle == Approx(lean).margin(1e-9));
        CHECK(walls[0].greatest_angle_beside_ends == Approx(lean).margin(1e-9));
        CHECK(walls[0].least_height == Approx(0.01));
        CHECK(walls[0].median_height == Approx(0.01));
        CHECK(walls[0].greatest_height == Approx(0.01));
    }
}

TEST_CASE("the wall's normal is exact on a circle whose points are unequally spaced") {
    const PointField x = sampled({21, 2, 1}, [](double i, double j, double) {
        const double angle = pi * (0.01 * i + 0.002 * i * i);
        return Vec3{(1 + 0.1 * j) * std::cos(angle), (1 + 0.1 * j) * std::sin(angle), 0};
    });
    const auto walls = measure_walls(with_wall(x, {{0, 0, 0}, {20, 0, 0}}));
    CHECK(walls[0].greatest_angle < 1e-10);
    CHECK(walls[0].greatest_angle_beside_ends < 1e-10);
}

TEST_CASE("walls are told by their type, from either side of a zone, in three dimensions too") {
    PointField x = sampled({6, 7, 4}, [](double i, double j, double k) {
        return Vec3{i + 0.1 * (3 - k), j, 0.5 * k};
    });
    const auto walls = measure_walls(with_wall(x, {{0, 0, 3}, {5, 6, 3}}));
    REQUIRE(walls.size() == 1);
    CHECK(walls[0].nodes == 2 * 3);
    CHECK(walls[0].mean_angle == Approx(std::atan(0.2) * 180 / pi));
    CHECK(walls[0].least_height == Approx(std::hypot(0.1, 0.5)));
    MultiblockGrid none = with_wall(x, {{0, 0, 3}, {5, 6, 3}});
    none.families[1].type = "BCSymmetryPlane";
    CHECK(measure_walls(none).empty());
}

TEST_CASE("heights are those of all nodes of a wall, the ends of its patches too") {
    const PointField x = sampled({6, 3, 1}, [](double i, double j, double) {
        return Vec3{i, j * (0.1 + 0.02 * i), 0};
    });
    const auto walls = measure_walls(with_wall(x, {{0, 0, 0}, {5, 0, 0}}));
    REQUIRE(walls.size() == 1);
    CHECK(walls[0].nodes == 2);  // for angles, away from the ends
    CHECK(walls[0].least_height == Approx(0.1));
    CHECK(walls[0].median_height == Approx(0.15));  // between the two in the middle
    CHECK(walls[0].greatest_height == Approx(0.2));
    // At a pole there is no first cell.
    const PointField fan = sampled({4, 3, 1}, [](double i, double j, double) {
        return Vec3{i, 0.1 * i * j, 0};
    });
    const auto of_fan = measure_walls(with_wall(fan, {{0, 0, 0}, {3, 0, 0}}));
    CHECK(of_fan[0].least_height == Approx(0.1));
    CHECK(of_fan[0].median_height == Approx(0.2));
}
