// SPDX-License-Identifier: Apache-2.0
// Grids made of whole grids: swept and mirrored.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "blocks/mirror_grid.h"
#include "blocks/sweep_grid.h"
#include "core/periodic_image.h"
#include "quality/measure.h"

using namespace hexweave;

namespace {

constexpr double pi = std::numbers::pi;

/// Two zones beside each other over 0 <= x <= 2, 0 <= y <= 1, the second with its axes turned by a
/// right angle; families `low` at y = 0, `left` at x = 0, `ends` for start and end.
MultiblockGrid two_squares() {
    MultiblockGrid grid;
    grid.cell_dimension = grid.physical_dimension = 2;
    Zone a{"a", PointField(Extent{5, 4, 1})};
    Zone b{"b", PointField(Extent{4, 6, 1})};
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 5; ++i) a.points.set(i, j, 0, {0.25 * i, j / 3.0, 0});
    }
    for (int j = 0; j < 6; ++j) {
        for (int i = 0; i < 4; ++i) b.points.set(i, j, 0, {2 - j / 5.0, i / 3.0, 0});
    }
    grid.zones = {a, b};
    grid.interfaces.push_back(
        {"between", 0, {{4, 0, 0}, {4, 3, 0}}, 1, {{0, 5, 0}, {3, 5, 0}}, Orientation{{-2, 1, 3}}});
    grid.families = {{"low", "BCWall"}, {"left", "BCSymmetryPlane"}, {"ends", "BCFarfield"}};
    grid.patches = {{"low_a", 0, {{0, 0, 0}, {4, 0, 0}}, 0},
                    {"low_b", 1, {{0, 0, 0}, {0, 5, 0}}, 0},
                    {"left", 0, {{0, 0, 0}, {0, 3, 0}}, 1}};
    return grid;
}

/// Nothing folded, every interface with the same points (images) on its two sides.
void check_sound(const MultiblockGrid& grid) {
    for (const Zone& zone : grid.zones) {
        const ZoneMeasure measure = measure_zone(zone, grid.physical_dimension);
        CHECK(measure.folded == 0);
        CHECK(measure.worst_scaled_jacobian > 0.5);
    }
    for (const Interface& interface : grid.interfaces) {
        INFO(interface.name);
        CHECK(measure_interface(grid, interface).mismatched == 0);
    }
}

}  // namespace

TEST_CASE("an extruded grid has its planar grid in every layer") {
    const MultiblockGrid planar = two_squares();
    Sweep sweep;
    sweep.whole.translation = {0, 0, 0.3};
    sweep.length = 0.3;
    sweep.cells = 2;
    sweep.ends = {"ends", "ends"};
    const MultiblockGrid grid = swept(planar, sweep);
    check_sound(grid);
    CHECK(grid.cell_dimension == 3);
    CHECK(grid.zones[0].points.extent() == Extent{5, 4, 3});
    const Vec3 p = planar.zones[1].points(2, 3);
    CHECK(grid.zones[1].points(2, 3, 0) == p);
    CHECK(grid.zones[1].points(2, 3, 1) == Vec3{p.x, p.y, 0.15});
    CHECK(grid.zones[1].points(2, 3, 2) == Vec3{p.x, p.y, 0.3});
    CHECK(grid.patches.size() == 3 + 2 * 2);
    CHECK(grid.patches[0].box == IndexBox{{0, 0, 0}, {4, 0, 2}});
}

TEST_CASE("an extrusion towards -z is right-handed too, its start behind its end") {
    Sweep sweep;
    sweep.whole.translation = {0.1, 0, -0.3};
    sweep.reversed = true;
    sweep.cells = 3;
    sweep.ends = {"low", "ends"};
    const MultiblockGrid grid = swept(two_squares(), sweep);
    check_sound(grid);
    CHECK(grid.zones[0].points(0, 0, 3).z == 0);
    const BoundaryPatch& start = grid.patches[3];
    CHECK((start.name == "start" && start.family == 0 && start.box.begin[2] == 3));
}

TEST_CASE("ends that are joined are images of each other") {
    Sweep sweep;
    sweep.whole.translation = {0.1, 0, 0.3};
    sweep.cells = 3;
    sweep.joined = true;
    const MultiblockGrid grid = swept(two_squares(), sweep);
    check_sound(grid);
    REQUIRE(grid.interfaces.size() == 3);
    CHECK(grid.interfaces[1].periodic->translation == Vec3{0.1, 0, 0.3});
    const PeriodicMap map = periodic_map(*grid.interfaces[1].periodic);
    const PointField& x = grid.zones[0].points;
    CHECK(image(map, x(3, 2, 0)) == x(3, 2, 3));
}

TEST_CASE("a quarter turn ends exactly in its plane; what is on the axis stays there") {
    Sweep sweep;
    sweep.whole.angle = {pi / 2, 0, 0};
    sweep.cells = 6;
    sweep.ends = {"ends", "ends"};
    const MultiblockGrid grid = swept(two_squares(), sweep);
    check_sound(grid);
    const PointField& x = grid.zones[0].points;
    for (int k = 0; k < 7; ++k) CHECK(x(3, 0, k) == Vec3{0.75, 0, 0});
    CHECK(x(3, 2, 6) == Vec3{0.75, 0, 2 / 3.0});
    CHECK(norm(x(3, 3, 2) - Vec3{0.75, 0, 0}) == Approx(1).epsilon(1e-15));
}

TEST_CASE("a full turn ends where it began") {
    Sweep sweep;
    sweep.whole = {{0, -1, 0}, {2 * pi, 0, 0}, {}};
    sweep.cells = 12;
    sweep.joined = sweep.full_turn = true;
    const MultiblockGrid grid = swept(two_squares(), sweep);
    check_sound(grid);
    CHECK(!grid.interfaces[1].periodic);
    CHECK(grid.zones[0].points(2, 2, 12) == grid.zones[0].points(2, 2, 0));
}

TEST_CASE("a mirror image is joined at the plane and right-handed") {
    const MultiblockGrid half = two_squares();
    const MultiblockGrid grid = with_mirror_image(half, {{0, 0.0}, 1, false});
    check_sound(grid);
    REQUIRE(grid.zones.size() == 4);
    CHECK(grid.zones[3].name == "b_mirror");
    REQUIRE(grid.interfaces.size() == 3);
    CHECK(grid.interfaces[2].zone == 0);
    CHECK(grid.interfaces[2].donor == 2);
    const Vec3 p = half.zones[1].points(1, 2);
    CHECK(grid.zones[3].points(2, 2) == Vec3{-p.x, p.y, 0});
    // The family at the plane is gone, the others are shared.
    REQUIRE(grid.families.size() == 2);
    CHECK(grid.families[1].name == "ends");
    CHECK(grid.patches.size() == 4);
    for (const BoundaryPatch& patch : grid.patches) CHECK(patch.family == 0);
}

TEST_CASE("the families of a mirror image may be apart") {
    const MultiblockGrid grid = with_mirror_image(two_squares(), {{0, 0.0}, 1, true});
    REQUIRE(grid.families.size() == 3);
    CHECK(grid.families[1].name == "low_mirror");
    CHECK(grid.families[1].type == "BCWall");
    CHECK(grid.patches[1].family == 1);
}

TEST_CASE("sides of j and k are joined with their images as well") {
    MultiblockGrid half = two_squares();
    const MultiblockGrid low = with_mirror_image(half, {{1, 0.0}, 0, false});
    check_sound(low);
    CHECK(low.interfaces.size() == 4);

    Sweep sweep;
    sweep.whole.translation = {0, 0, 0.3};
    sweep.cells = 2;
    sweep.ends = {"ends", "left"};
    MultiblockGrid solid = swept(half, sweep);
    solid.patches.erase(solid.patches.begin() + 2);
    const MultiblockGrid behind = with_mirror_image(solid, {{2, 0.0}, 2, false});
    check_sound(behind);
    CHECK(behind.interfaces.size() == 4);
}

TEST_CASE("the image of a periodic interface is one by the mirrored map") {
    for (const Periodicity& periodicity :
         {Periodicity{{1, 2, 0}, {0, 0, 0.3}, {}}, Periodicity{{1, 2, 3}, {0, 0.3, 0}, {}},
          Periodicity{{}, {}, {4, 5, 6}}}) {
        MultiblockGrid half = two_squares();
        const IndexBox left{{0, 0, 0}, {0, 3, 0}};
        half.interfaces.push_back({"turn", 0, left, 0, left, Orientation{}, periodicity});
        const MultiblockGrid grid = with_mirror_image(half, {{1, 0.0}, 0, false});
        REQUIRE(grid.interfaces[3].name == "turn_mirror");
        const auto mirrored = [](const Vec3& v) { return Vec3{v.x, -v.y, v.z}; };
        const Vec3 p{0.4, 0.7, -0.2};
        const Vec3 wanted = mirrored(image(periodic_map(periodicity), p));
        const PeriodicMap map = periodic_map(*grid.interfaces[3].periodic);
        CHECK(distance(image(map, mirrored(p)), wanted) < 1e-15);
    }
}
