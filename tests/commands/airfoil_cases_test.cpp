// SPDX-License-Identifier: Apache-2.0
// The shipped airfoils: how square, smooth and high their cells are.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "core/multiblock.h"
#include "io/cgns.h"
#include "quality/walls.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;
using Json = nlohmann::json;

namespace {

Json report_of(const Scratch& scratch, const std::string& arguments) {
    const Finished run = scratch.hexweave("run --json report.json " + arguments);
    INFO(run.out << run.err);
    REQUIRE(run.exit_code == 0);
    return Json::parse(scratch.read("report.json"))["report"];
}

/// The greatest growth along i (0) or j (1), over all zones.
double greatest_growth(const Json& report, std::size_t axis) {
    double greatest = 1;
    for (const Json& zone : report["zones"]) {
        greatest = std::max(greatest, zone["growth"][axis]["ratio"].get<double>());
    }
    return greatest;
}

double share(const Json& angles, const char* within) {
    return angles[within].get<double>() / angles["corners"].get<double>();
}

}  // namespace

TEST_CASE("the grid about airfoil and flap is held at both walls, smooth and nearly square") {
    const Scratch scratch;
    REQUIRE(scratch
                .hexweave("run --quiet " + shipped("two_element.yaml") +
                          " --json report.json -o flap.cgns")
                .exit_code == 0);
    const Json report = Json::parse(scratch.read("report.json"))["report"];
    CHECK(report["angles"]["least"] > 50);
    CHECK(report["angles"]["greatest"] < 125);
    REQUIRE(report["walls"].size() == 2);
    for (const Json& wall : report["walls"]) {
        INFO(wall["family"]);
        CHECK(wall["least_height"].get<double>() == Approx(1e-5).epsilon(1e-3));
        CHECK(wall["greatest_height"].get<double>() == Approx(1e-5).epsilon(1e-3));
        CHECK(wall["greatest_angle"] < 1);
        CHECK(wall["greatest_angle_beside_ends"] < 1.5);
    }
    for (const Json& zone : report["zones"]) {
        const bool at_five_fold_points = zone["name"] == "wing" || zone["name"] == "under";
        INFO(zone["name"]);
        CHECK(zone["growth"][0]["ratio"] < 1.45);
        CHECK(zone["growth"][1]["ratio"] < (at_five_fold_points ? 1.8 : 1.33));
    }
    for (const Json& interface : report["interfaces"]) {
        INFO(interface["name"]);
        CHECK(interface["growth"]["ratio"] < (interface["name"] == "front" ? 2.5 : 1.7));
    }
}

TEST_CASE("the flap of two elements may be moved and turned, and takes its lines along") {
    for (const char* placed :
         {"--set flap_y=-0.03 --set angle=0.44", "--set flap_x=1 --set angle=0.26"}) {
        INFO(placed);
        const Scratch scratch;
        const Finished run = scratch.hexweave("run " + shipped("two_element.yaml") + " " + placed +
                                              " -o moved.cgns");
        INFO(run.out << run.err);
        CHECK(run.exit_code == 0);
    }
}

TEST_CASE("grid lines of the NACA 0012 leave the airfoil upright, up to its trailing edge") {
    const Scratch scratch;
    const Json report = report_of(scratch, shipped("naca0012.yaml") + " -o naca.cgns");
    const Json& wall = report["walls"][0];
    CHECK(wall["mean_angle"] < 0.8);
    CHECK(wall["greatest_angle"] < 12);
    // Beside the ends of its four patches too, but for the one column beside the trailing edge.
    MultiblockGrid grid = read_cgns(scratch.path() / "naca.cgns");
    for (BoundaryPatch& patch : grid.patches) {
        const PointField& x = grid.zones[static_cast<std::size_t>(patch.zone)].points;
        if (x(patch.box.begin[0], 0).x == 1) ++patch.box.begin[0];
        if (x(patch.box.end[0], 0).x == 1) --patch.box.end[0];
    }
    for (const WallMeasure& m : measure_walls(grid)) CHECK(m.greatest_angle_beside_ends < 12);
    // Along the lines round the airfoil, from face to face too.
    CHECK(greatest_growth(report, 0) < 1.3);
    for (const Json& interface : report["interfaces"]) CHECK(interface["growth"]["ratio"] < 1.3);
    for (const Json& solve : report["solves"]) {
        const bool at_trailing_edge = !solve["flat_at"].empty();
        CHECK(solve["orthogonality"]["passes"] == (at_trailing_edge ? 1 : 2));
        CHECK(solve["orthogonality"]["end"] == "all passes done");
    }
}

TEST_CASE("the cells of the RAE 2822 are nearly rectangles everywhere") {
    const Scratch scratch;
    const Json report = report_of(scratch, shipped("rae2822.yaml"));
    const Json& angles = report["angles"];
    CHECK(report["folded"] == 0);
    CHECK(angles["corners"] == 4 * 24576);
    CHECK(angles["least"] > 75);
    CHECK(angles["greatest"] < 105);
    CHECK(share(angles, "within_5") >= 0.89);
    CHECK(share(angles, "within_10") >= 0.98);
    CHECK(greatest_growth(report, 1) < 1.25);
    for (const Json& interface : report["interfaces"]) {
        if (interface["name"].get<std::string>().find("wake") == std::string::npos) continue;
        CHECK(interface["growth"]["ratio"] < 1.25);
    }
    const Json& wall = report["walls"][0];
    CHECK(wall["mean_angle"] < 0.2);
    CHECK(wall["greatest_angle"] < 0.6);
    CHECK(wall["greatest_angle_beside_ends"] < 0.6);
    CHECK(wall["least_height"] > 0.99e-5);
    CHECK(wall["greatest_height"] < 1.01e-5);
}
