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
