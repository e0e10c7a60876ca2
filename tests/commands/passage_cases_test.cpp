// SPDX-License-Identifier: Apache-2.0
// The shipped passages between vanes, against what is known of them exactly.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <tuple>

#include "core/multiblock.h"
#include "core/periodic_image.h"
#include "io/cgns.h"
#include "tests/commands/images.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;

TEST_CASE("the sides of the vane passages are images by the pitch, to the last bit") {
    const double step = 2 * std::acos(-1.0) / 36;
    for (const auto& [name, sizes, periodicity] :
         {std::tuple<std::string, std::string, Periodicity>{"vane", "", {{}, {}, {0, 0.85, 0}}},
          {"vane_annulus", small_annulus, {{}, {-step, 0, 0}, {}}}}) {
        INFO(name);
        const Scratch scratch;
        REQUIRE(scratch.hexweave("run --quiet " + shipped(name + ".yaml") + sizes + " -o vane.cgns")
                    .exit_code == 0);
        const MultiblockGrid grid = read_cgns(scratch.path() / "vane.cgns");
        const PeriodicMap map = periodic_map(periodicity);
        int periodic = 0;
        for (const Interface& interface : grid.interfaces) {
            if (!interface.periodic) continue;
            ++periodic;
            CHECK(not_images(grid, interface, map) == 0);
        }
        CHECK(periodic == 3);
    }
}

TEST_CASE("the vane's annulus lies between its hub and shroud, first cells off the vane held") {
    const Scratch scratch;
    REQUIRE(scratch
                .hexweave("run --quiet " + shipped("vane_annulus.yaml") + small_annulus +
                          " -o vane.cgns")
                .exit_code == 0);
    const MultiblockGrid grid = read_cgns(scratch.path() / "vane.cgns");
    const double middle = 0.85 * 36 / (2 * std::acos(-1.0));
    for_each_node(grid, "hub", [&](const Vec3& p) {
        CHECK(std::hypot(p.y, p.z) == Approx(middle - 0.3).epsilon(1e-12));
    });
    for_each_node(grid, "shroud", [&](const Vec3& p) {
        CHECK(std::hypot(p.y, p.z) == Approx(middle + 0.3).epsilon(1e-12));
    });
    for (const Zone& zone : grid.zones) {
        if (zone.name != "front" && zone.name != "top" && zone.name != "rear" &&
            zone.name != "bottom") {
            continue;
        }
        const Extent e = zone.points.extent();
        for (int k = 0; k < e.nk; ++k) {
            for (int i = 0; i < e.ni; ++i) {
                CHECK(distance(zone.points(i, 0, k), zone.points(i, 1, k)) ==
                      Approx(2e-5).epsilon(0.05));
            }
        }
    }
}
