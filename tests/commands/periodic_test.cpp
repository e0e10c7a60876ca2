// SPDX-License-Identifier: Apache-2.0
// Periodic interfaces through the whole program: the two sides are exact images in the file.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "core/multiblock.h"
#include "core/periodic_image.h"
#include "io/cgns.h"
#include "tests/commands/images.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;
using Catch::Matchers::Contains;

namespace {

std::string good_case(const std::string& name) {
    return HEXWEAVE_SOURCE_DIR "/tests/cases/good/" + name + ".yaml";
}

/// Runs a case of tests/cases/good, has cgnscheck look at the file, and reads it back.
MultiblockGrid checked_grid(const Scratch& scratch, const std::string& name) {
    const Finished run = scratch.hexweave("run " + good_case(name) + " --strict -o grid.cgns");
    INFO(run.out << run.err);
    REQUIRE(run.exit_code == 0);
    const Finished check = scratch.shell("cgnscheck -w3 grid.cgns");
    INFO(check.out);
    CHECK(check.out.find("ERROR") == std::string::npos);
    CHECK(check.out.find("WARNING") == std::string::npos);
    return read_cgns(scratch.path() / "grid.cgns");
}

}  // namespace

TEST_CASE("the sides of a channel that is periodic by translation are exact images") {
    const Scratch scratch;
    const MultiblockGrid grid = checked_grid(scratch, "periodic_channel");
    const PeriodicMap map = periodic_map({{}, {}, {0, 0.7, 0}});
    int periodic = 0;
    for (const Interface& interface : grid.interfaces) {
        if (!interface.periodic) continue;
        ++periodic;
        CHECK(interface.periodic->translation.y == Approx(0.7).epsilon(1e-7));
        CHECK(not_images(grid, interface, map) == 0);
    }
    CHECK(periodic == 2);
    CHECK(grid.interfaces.size() == 3);
    CHECK(grid.patches.size() == 2);
}

TEST_CASE("the sides of an annular sector are exact images by rotation") {
    const Scratch scratch;
    const MultiblockGrid grid = checked_grid(scratch, "annular_sector");
    const double pitch = 2 * std::numbers::pi / 18;
    const PeriodicMap map = periodic_map({{}, {pitch, 0, 0}, {}});
    int periodic = 0;
    for (const Interface& interface : grid.interfaces) {
        if (!interface.periodic) continue;
        ++periodic;
        CHECK(interface.periodic->angle.x == Approx(pitch).epsilon(1e-7));
        CHECK(not_images(grid, interface, map) == 0);
    }
    CHECK(periodic == 2);
    // Units stand beside the angle, in radians.
    const Finished file = scratch.shell("cgnscheck -v grid.cgns");
    CHECK_THAT(file.out, Contains("Angle=[0.349066,0,0]") && Contains("Exponents=[0,0,0,0,1]"));
}

TEST_CASE("check lists periodic interfaces and tells where a side has its points from") {
    const Scratch scratch;
    CHECK_THAT(scratch.hexweave("check " + good_case("periodic_channel")).out,
               Contains("periodic:\n  pitch                    translation [0, 0.7]: low1 -> up1, "
                        "low2 -> up2\n"));
    CHECK_THAT(scratch.hexweave("check --explain up2 " + good_case("periodic_channel")).out,
               Contains("its points are the image of those of edge 'low2', reversed, by 'pitch'"));
}

TEST_CASE("quality reads a periodic grid and finds its sides to be images") {
    const Scratch scratch;
    checked_grid(scratch, "annular_sector");
    const Finished quality = scratch.hexweave("quality grid.cgns --json quality.json");
    CHECK(quality.exit_code == 0);
    const auto json = nlohmann::json::parse(scratch.read("quality.json"));
    for (const auto& interface : json["interfaces"]) CHECK(interface["mismatched"] == 0);
    CHECK(json["interfaces"].size() == 3);
}

TEST_CASE("a quarter of a nozzle is revolved between exact symmetry planes") {
    const Scratch scratch;
    const MultiblockGrid grid = checked_grid(scratch, "revolved_channel");
    REQUIRE(grid.zones.size() == 1);
    const PointField& x = grid.zones[0].points;
    CHECK(x.extent() == Extent{17, 13, 9});
    for (int i = 0; i < 17; ++i) {
        for (int j = 0; j < 13; ++j) {
            CHECK(x(i, j, 0).z == 0);
            CHECK(x(i, j, 8).y == 0);
        }
        for (int k = 0; k < 9; ++k) CHECK((x(i, 0, k).y == 0 && x(i, 0, k).z == 0));
    }
    CHECK(grid.families.back().type == "BCDegenerateLine");
}

TEST_CASE("a bump is mirrored at its crest and extruded") {
    const Scratch scratch;
    const MultiblockGrid grid = checked_grid(scratch, "extruded_bump");
    REQUIRE(grid.zones.size() == 2);
    CHECK(grid.zones[1].name == "front_mirror");
    CHECK(grid.interfaces.size() == 1);
    CHECK(not_images(grid, grid.interfaces[0], PeriodicMap{}) == 0);
    const PointField& x = grid.zones[0].points;
    for (int j = 0; j < 11; ++j) CHECK(x(20, j, 1).x == 0);
    CHECK(x(3, 4, 1).z == 0.1);
    CHECK_THAT(scratch.hexweave("check " + good_case("extruded_bump")).out,
               Contains("swept by a translation [0, 0, 0.1], 1 cell, from slices to slices\n"
                        "mirrored at crest, x = 0: every zone twice\n"));
}
