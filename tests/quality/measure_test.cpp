// SPDX-License-Identifier: Apache-2.0
#include "quality/measure.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "quality/cell_statistics.h"
#include "quality/walls.h"

using namespace hexweave;

namespace {

const double pi = std::acos(-1.0);

Zone make_zone(Extent extent, const std::function<Vec3(double, double, double)>& map) {
    Zone zone{"zone", PointField(extent)};
    for (int k = 0; k < extent.nk; ++k)
        for (int j = 0; j < extent.nj; ++j)
            for (int i = 0; i < extent.ni; ++i) zone.points.set(i, j, k, map(i, j, k));
    return zone;
}

}  // namespace

TEST_CASE("a box of cubes has scaled Jacobian one and no fold") {
    const ZoneMeasure m = measure_zone(make_zone({4, 5, 6},
                                                 [](double i, double j, double k) {
                                                     return Vec3{i, j, k};
                                                 }),
                                       3);
    CHECK(m.cells == 60);
    CHECK(m.folded == 0);
    CHECK(m.flat_corners == 0);
    CHECK(m.worst_scaled_jacobian == Approx(1).epsilon(1e-15));
}

TEST_CASE("the worst place of a zone lies in the zone, though all of it be perfect") {
    for (const int nk : {3, 1}) {
        const ZoneMeasure m = measure_zone(make_zone({4, 5, nk},
                                                     [](double i, double j, double k) {
                                                         return Vec3{7 + i, 8 + 2 * j, 9 + k};
                                                     }),
                                           nk == 1 ? 2 : 3);
        CHECK(m.worst_scaled_jacobian == 1);
        CHECK(m.angles.greatest == 90);
        for (const Vec3& place : {m.worst_place, m.angles.worst_place(), m.growth[0].place}) {
            CHECK(place.x >= 7);
            CHECK(place.y >= 8);
            CHECK(place.z >= 9);
        }
        CHECK(m.growth[0].measured);
        CHECK(m.growth[2].measured == (nk > 2));
        AngleMeasure all;
        all.include(AngleMeasure{});
        all.include(m.angles);
        CHECK(all.worst_place() == m.angles.worst_place());
    }
}

TEST_CASE("in a zone one cell thick lines leave a wall within its sections") {
    // Cells that lean by 0.2 radians, about an axis at y = -5 in two wedges, or straight on.
    for (const double wedge : {0.0, 0.3}) {
        MultiblockGrid grid;
        grid.zones.push_back(make_zone({7, 4, 2}, [&](double i, double j, double k) {
            const double radius = 5 + j;
            return Vec3{i + j * std::tan(0.2), radius * std::cos(wedge * k) - 5,
                        wedge == 0 ? k : radius * std::sin(wedge * k)};
        }));
        grid.families = {{"wall", "BCWallViscous"}};
        grid.patches.push_back({"wall", 0, {{0, 0, 0}, {6, 0, 1}}, 0});
        const WallMeasure wall = measure_walls(grid).front();
        CHECK(wall.nodes == 2 * 3);
        CHECK(wall.mean_angle == Approx(0.2 * 180 / pi).epsilon(1e-9));
        CHECK(wall.greatest_angle == Approx(0.2 * 180 / pi).epsilon(1e-9));
        CHECK(wall.greatest_angle_beside_ends == Approx(0.2 * 180 / pi).epsilon(1e-9));
    }
}

TEST_CASE(
    "the scaled Jacobian of sheared cells is the sine of their angle, whatever their aspect") {
    const double angle = pi / 3;
    const auto shear = [angle](double i, double j, double) {
        return Vec3{i + 1e-5 * j * std::cos(angle), 1e-5 * j * std::sin(angle), 0};
    };
    const ZoneMeasure m = measure_zone(make_zone({5, 5, 1}, shear), 2);
    CHECK(m.worst_scaled_jacobian == Approx(std::sin(angle)).epsilon(1e-9));
    CHECK(m.cells == 16);
}

TEST_CASE("a left-handed block is folded everywhere, a left-handed plane too") {
    const auto mirrored = [](double i, double j, double k) { return Vec3{-i, j, k}; };
    CHECK(measure_zone(make_zone({3, 3, 3}, mirrored), 3).folded == 8);
    CHECK(measure_zone(make_zone({3, 3, 1}, mirrored), 2).folded == 4);
}

TEST_CASE("a surface has no outside: only its own folds count") {
    const auto mirrored = [](double i, double j, double) { return Vec3{-i, j, 0.1 * i * j}; };
    CHECK(measure_zone(make_zone({3, 3, 1}, mirrored), 3).folded == 0);
    Zone zone = make_zone({5, 5, 1}, mirrored);
    zone.points.set(2, 2, 0, {-4.5, 4.5, 0});
    CHECK(measure_zone(zone, 3).folded > 0);
}

TEST_CASE("a cell the wrong way round is folded in any plane, also of points in single precision") {
    const double c = std::cos(0.4);
    const double s = std::sin(0.4);
    const auto tilted = [&](double i, double j, double) { return Vec3{c * i, j, s * i + 3}; };
    const auto rounded = [&](double i, double j, double) {
        const auto single = [](double value) {
            return static_cast<double>(static_cast<float>(value));
        };
        return Vec3{single(c * i), single(j), single(s * i + 3)};
    };
    const auto level = [](double i, double j, double) { return Vec3{i, j, 0}; };
    for (const auto& shape : std::vector<std::function<Vec3(double, double, double)>>{
             tilted, rounded, level,
             [&](double i, double j, double k) { return level(-i, j, k); }}) {
        // Two lines of nodes exchanged: the cells between them lie the wrong way round.
        Zone zone = make_zone({6, 5, 1}, [&](double i, double j, double k) {
            return shape(i == 2 ? 3 : i == 3 ? 2 : i, j, k);
        });
        const ZoneMeasure m = measure_zone(zone, 3);
        CHECK(m.folded == 4);
        CHECK(m.worst_scaled_jacobian == Approx(-1).epsilon(1e-6));
        CHECK(cell_statistics(zone, 3, 10).quality.not_positive == 4);
    }
}

TEST_CASE("one node pulled through its neighbours folds the cells around it and is named") {
    Zone zone = make_zone({5, 5, 5}, [](double i, double j, double k) { return Vec3{i, j, k}; });
    zone.points.set(2, 2, 2, {3.5, 2, 2});
    const ZoneMeasure m = measure_zone(zone, 3);
    CHECK(m.folded >= 4);
    CHECK(m.worst_scaled_jacobian < 0);
    CHECK(m.worst_cell[0] >= 1);
    CHECK(m.worst_cell[0] <= 2);
}

TEST_CASE("corners on the boundary do not count inside") {
    for (const int nk : {5, 1}) {
        Zone zone = make_zone({5, 5, nk}, [](double i, double j, double k) {
            return Vec3{i, j, k};
        });
        const int k = nk / 2;
        zone.points.set(0, 0, k, {0.5, 0.3, static_cast<double>(k)});
        ZoneMeasure m = measure_zone(zone, nk == 1 ? 2 : 3);
        CHECK(m.worst_scaled_jacobian < 0.9);
        CHECK(m.worst_inside == Approx(1).epsilon(1e-15));
        zone.points.set(2, 2, k, {2.5, 2, static_cast<double>(k)});
        m = measure_zone(zone, nk == 1 ? 2 : 3);
        CHECK(m.worst_inside == Approx(nk == 1 ? 2 / std::sqrt(5.0) : 0.8).epsilon(1e-12));
        CHECK(m.worst_scaled_jacobian < m.worst_inside);
    }
    CHECK(measure_zone(make_zone({2, 2, 2},
                                 [](double i, double j, double k) {
                                     return Vec3{i, j, k};
                                 }),
                       3)
              .worst_inside == 1);
}

TEST_CASE("a node that is not a number is a fold") {
    Zone zone = make_zone({3, 3, 1}, [](double i, double j, double) { return Vec3{i, j, 0}; });
    zone.points.set(1, 1, 0, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
    const ZoneMeasure m = measure_zone(zone, 2);
    CHECK(m.folded == 4);
    CHECK(!(m.worst_scaled_jacobian > 0));
}

TEST_CASE("a corner where two sides meet at 180 degrees is counted apart, a turned one is a fold") {
    // The unit square with its corner (0, 0) pushed onto the straight line between its neighbours.
    const auto square = [](double i, double j, double) { return Vec3{i, j, 0}; };
    Zone flat = make_zone({3, 3, 1}, square);
    flat.points.set(0, 0, 0, {0.5, 0.5, 0});
    const ZoneMeasure m = measure_zone(flat, 2);
    CHECK(m.flat_corners == 1);
    CHECK(m.folded == 0);

    Zone turned = make_zone({3, 3, 1}, square);
    turned.points.set(0, 0, 0, {0.6, 0.6, 0});
    CHECK(measure_zone(turned, 2).folded == 1);
}

TEST_CASE("a block edge at 180 degrees gives flat corners all along it") {
    // Half a cylinder whose sides theta = 0 and theta = pi meet along the axis x = y = 0.
    const auto half_disc = [](double i, double j, double k) {
        const double u = i / 4;
        const double v = j / 4;
        // A square (u, v) bent open so that its sides u = 0 and v = 0 lie in one plane.
        return Vec3{u * u - v * v, 2 * u * v, k};
    };
    const ZoneMeasure m = measure_zone(make_zone({5, 5, 4}, half_disc), 3);
    CHECK(m.flat_corners == 6);
    CHECK(m.folded == 0);
}

TEST_CASE("corners at a pole are counted apart, folds beside it are not") {
    const auto polar = [](double i, double j, double k) {
        return Vec3{i * std::cos(0.3 * j), i * std::sin(0.3 * j), k};
    };
    // Two corners of each of the four cells at the centre; of a block's cells four.
    Zone face = make_zone({4, 5, 1}, polar);
    CHECK(measure_zone(face, 2).pole_corners == 8);
    CHECK(measure_zone(face, 2).folded == 0);
    CHECK(measure_zone(face, 2).worst_scaled_jacobian == Approx(std::cos(0.15)));
    Zone block = make_zone({4, 5, 3}, polar);
    const ZoneMeasure m = measure_zone(block, 3);
    CHECK(m.pole_corners == 32);
    CHECK(m.folded == 0);
    CHECK(m.flat_corners == 0);
    block.points.set(1, 2, 1, -1.0 * block.points(1, 2, 1));
    CHECK(measure_zone(block, 3).folded > 0);
    // Two neighbours inside of a grid that are one point are no pole.
    face.points.set(1, 2, 0, face.points(2, 2));
    CHECK(measure_zone(face, 2).folded > 0);
}

TEST_CASE("a side that is collapsed to a line has no normal to measure angles from") {
    const auto polar = [](double i, double j, double k) {
        return Vec3{i * std::cos(0.3 * j), i * std::sin(0.3 * j), k};
    };
    MultiblockGrid grid;
    grid.zones.push_back(make_zone({4, 6, 7}, polar));
    grid.families = {{"axis", "BCDegenerateLine"}, {"rim", "BCWall"}};
    grid.patches.push_back({"axis", 0, {{0, 0, 0}, {0, 5, 6}}, 0});
    grid.patches.push_back({"rim", 0, {{3, 0, 0}, {3, 5, 6}}, 1});
    const std::vector<WallMeasure> measured = measure_boundaries(grid);
    REQUIRE(measured.size() == 2);
    CHECK(measured[0].nodes == 0);
    CHECK(measured[0].mean_angle == 0);
    CHECK(measured[0].greatest_angle_beside_ends == 0);
    CHECK(measured[1].nodes == 2 * 3);
    CHECK(measured[1].median_height == Approx(1));
    CHECK(measured[1].greatest_angle < 1e-5);
}

TEST_CASE("an unsound report says so") {
    Report report;
    CHECK(report.sound());
    report.zones.push_back({});
    report.zones[0].folded = 2;
    CHECK(report.folded() == 2);
    CHECK(!report.sound());
    report.zones[0].folded = 0;
    report.solves.push_back({});
    report.solves[0].result.status = SolveStatus::not_converged;
    CHECK(report.unconverged() == 1);
    CHECK(!report.sound());
    report.solves.clear();
    report.interfaces.push_back({"i", 1, {}});
    CHECK(!report.sound());
}
