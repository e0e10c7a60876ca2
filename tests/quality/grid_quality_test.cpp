// SPDX-License-Identifier: Apache-2.0
// The quality of grids of which it is known.
#include "quality/grid_quality.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <utility>

#include "core/parallel.h"
#include "quality/cell_measures.h"

using namespace hexweave;

namespace {

const double pi = std::acos(-1.0);

Zone zone_of(const std::string& name, Extent extent,
             const std::function<Vec3(double, double, double)>& map) {
    Zone zone{name, PointField(extent)};
    for (int k = 0; k < extent.nk; ++k)
        for (int j = 0; j < extent.nj; ++j)
            for (int i = 0; i < extent.ni; ++i) zone.points.set(i, j, k, map(i, j, k));
    return zone;
}

/// Cells of size 1 x 1 x 1/2, sheared along i by k so that the angle between i and k is given.
MultiblockGrid sheared_box(double degrees) {
    const double angle = degrees * pi / 180;
    MultiblockGrid grid;
    grid.zones.push_back(zone_of("box", {4, 5, 6}, [angle](double i, double j, double k) {
        return Vec3{i + 0.5 * k * std::cos(angle), j, 0.5 * k * std::sin(angle)};
    }));
    return grid;
}

/// Polar coordinates: i around in steps of 6 degrees, j outwards from radius 1 in steps of 0.1.
MultiblockGrid annulus() {
    MultiblockGrid grid;
    grid.cell_dimension = 2;
    grid.physical_dimension = 2;
    grid.zones.push_back(zone_of("ring", {61, 11, 1}, [](double i, double j, double) {
        const double angle = -i * pi / 30;
        const double radius = 1 + 0.1 * j;
        return Vec3{radius * std::cos(angle), radius * std::sin(angle), 0};
    }));
    return grid;
}

std::size_t count_of(const GridQuality& q, const std::string& measure, std::size_t bin) {
    for (const Histogram& h : q.histograms) {
        if (h.measure == measure) return h.counts.at(bin);
    }
    FAIL("no histogram of " << measure);
    return 0;
}

}  // namespace

TEST_CASE("a sheared box has the measures of its one cell") {
    const GridQuality q = measure_quality(sheared_box(60));
    REQUIRE(q.zones.size() == 1);
    const ZoneQuality& z = q.zones[0];
    const double height = 0.5 * std::sin(pi / 3);
    CHECK(q.sound());
    CHECK(z.positive == 60);
    CHECK(z.volume == Approx(60 * height).epsilon(1e-12));
    CHECK(z.least_volume.value == Approx(height).epsilon(1e-12));
    CHECK(z.least_jacobian.value == Approx(height).epsilon(1e-12));
    CHECK(z.measure.worst_scaled_jacobian == Approx(std::sin(pi / 3)).epsilon(1e-12));
    CHECK(z.greatest_skewness.value == Approx(30.0 / 90).epsilon(1e-12));
    CHECK(z.mean_skewness == Approx(30.0 / 90).epsilon(1e-12));
    CHECK(z.greatest_aspect_ratio.value == Approx(2).epsilon(1e-12));
    for (const BendMeasure& bends : z.bends) CHECK(bends.greatest == Approx(0).margin(1e-6));
    CHECK(count_of(q, "scaled Jacobian", 9) == 60);     // 0.8 to 0.9
    CHECK(count_of(q, "equiangle skewness", 3) == 60);  // 0.3 to 0.4
    CHECK(count_of(q, "degrees from 90", 0) == 60 * 16);
    CHECK(count_of(q, "degrees from 90", 3) + count_of(q, "degrees from 90", 4) == 60 * 8);
}

TEST_CASE("an annulus bends by its step and stands upright on its circles") {
    MultiblockGrid grid = annulus();
    name_sides_where_nothing_is_named(grid);
    const GridQuality q = measure_quality(grid);
    const ZoneQuality& z = q.zones[0];
    CHECK(z.bends[0].greatest == Approx(6).epsilon(1e-9));
    CHECK(z.bends[0].mean() == Approx(6).epsilon(1e-9));
    CHECK(z.bends[1].greatest == Approx(0).margin(1e-5));
    // Chords: sixty trapezoids between polygons of radius 1 and 2.
    CHECK(z.volume == Approx(0.5 * 60 * std::sin(pi / 30) * 3).epsilon(1e-12));
    CHECK(z.greatest_skewness.value == Approx(3.0 / 90).epsilon(1e-9));
    REQUIRE(q.boundaries.size() == 4);
    const WallMeasure& inner = q.boundaries[2];
    CHECK(inner.family == "ring:jmin");
    CHECK(inner.median_height == Approx(0.1).epsilon(1e-12));
    CHECK(inner.greatest_angle == Approx(0).margin(1e-5));
}

TEST_CASE("a slope break across an interface is told where lines bend between zones") {
    MultiblockGrid grid;
    grid.cell_dimension = 2;
    grid.physical_dimension = 2;
    const double slope = std::tan(20 * pi / 180);
    grid.zones.push_back(zone_of("low", {5, 4, 1}, [](double i, double j, double) {
        return Vec3{i, j - 3, 0};
    }));
    grid.zones.push_back(zone_of("high", {5, 4, 1}, [slope](double i, double j, double) {
        return Vec3{i + slope * j, j, 0};
    }));
    grid.interfaces.push_back(
        {"line", 0, {{0, 3, 0}, {4, 3, 0}}, 1, {{0, 0, 0}, {4, 0, 0}}, Orientation{}});
    const GridQuality q = measure_quality(grid);
    REQUIRE(q.interfaces.size() == 1);
    CHECK(q.interfaces[0].measure.mismatched == 0);
    CHECK(q.interfaces[0].bends.nodes == 5);
    CHECK(q.interfaces[0].bends.greatest == Approx(20).epsilon(1e-9));
    CHECK(q.interfaces[0].measure.growth.ratio ==
          Approx(std::sqrt(1 + slope * slope)).epsilon(1e-12));
}

TEST_CASE("the worst cells come worst first, with their places") {
    MultiblockGrid grid = sheared_box(90);
    grid.zones[0].points.set(2, 2, 2, {2.4, 2.4, 1.2});
    const GridQuality q = measure_quality(grid, 3);
    REQUIRE(q.worst.size() == 3);
    CHECK(q.worst[0].scaled_jacobian <= q.worst[1].scaled_jacobian);
    CHECK(q.worst[1].scaled_jacobian <= q.worst[2].scaled_jacobian);
    CHECK(distance(q.worst[0].place, {2, 2, 1}) < 1.3);
    CHECK(q.worst[0].scaled_jacobian == q.zones[0].measure.worst_scaled_jacobian);
}

TEST_CASE("a folded cell makes a grid unsound, NaN too") {
    MultiblockGrid grid = sheared_box(90);
    grid.zones[0].points.set(2, 2, 2, {3.5, 2, 1});
    CHECK_FALSE(measure_quality(grid).sound());
    CHECK(measure_quality(grid).not_positive() > 0);
    grid.zones[0].points.set(2, 2, 2, {std::nan(""), 2, 1});
    CHECK_FALSE(measure_quality(grid).sound());
}

TEST_CASE("the quality of a grid does not depend on the number of threads") {
    MultiblockGrid grid = sheared_box(70);
    grid.zones[0].points.set(2, 2, 2, {2.2, 2.1, 1.1});
    set_threads(1);
    const GridQuality one = measure_quality(grid);
    set_threads(3);
    const GridQuality three = measure_quality(grid);
    set_threads(1);
    CHECK(one.zones[0].volume == three.zones[0].volume);
    CHECK(one.zones[0].mean_skewness == three.zones[0].mean_skewness);
    CHECK(one.zones[0].bends[0].sum == three.zones[0].bends[0].sum);
    CHECK(one.worst[9].cell == three.worst[9].cell);
}

TEST_CASE("the measures of one cell are those of the cell, not of its neighbours") {
    const MultiblockGrid box = sheared_box(60);
    const CellMeasures sheared = measure_cell(box.zones[0].points, {1, 2, 3}, {});
    CHECK(sheared.scaled_jacobian == Approx(std::sin(pi / 3)));
    CHECK(sheared.skewness == Approx(30.0 / 90));
    CHECK(sheared.aspect_ratio == Approx(2));
    CHECK(sheared.volume == Approx(0.5 * std::sin(pi / 3)));
}

TEST_CASE("a cell that is negative inside alone is the worst of all") {
    // Its sides shrink to nothing and grow again as it rises: the Jacobian is (1 - 2 z) (1 - 4 z).
    Zone hidden{"hidden", PointField({2, 2, 2})};
    Zone slanted{"slanted", PointField({2, 2, 2})};
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                hidden.points.set(i, j, k, {(1.0 - 2 * k) * i, (1.0 - 4 * k) * j, double(k)});
                slanted.points.set(i, j, k, {i + 20.0 * j, double(j), double(k)});
            }
    MultiblockGrid grid;
    grid.zones = {slanted, hidden};
    const GridQuality quality = measure_quality(grid);
    CHECK(quality.folded() == 0);
    CHECK(quality.not_positive() == 1);
    REQUIRE(quality.worst.size() == 2);
    CHECK(quality.worst[0].zone == "hidden");
    CHECK(quality.worst[0].scaled_jacobian > quality.worst[1].scaled_jacobian);
    CHECK(quality.worst[0].verdict == JacobianVerdict::not_positive);
    CHECK(quality.worst[1].verdict == JacobianVerdict::positive);
}
