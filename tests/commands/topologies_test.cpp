// SPDX-License-Identifier: Apache-2.0
// Folded sides and poles through the whole program, with another program's opinion of the files.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/multiblock.h"
#include "io/cgns.h"
#include "tests/commands/images.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;
using Json = nlohmann::json;

namespace {

/// Runs a case of tests/cases/good and reads the grid back.
MultiblockGrid sound_grid(const Scratch& scratch, const std::string& name, std::size_t poles) {
    const Finished run = scratch.hexweave("run " HEXWEAVE_SOURCE_DIR "/tests/cases/good/" + name +
                                          ".yaml --strict --json report.json -o grid.cgns");
    INFO(run.out << run.err);
    REQUIRE(run.exit_code == 0);
    std::size_t pole_corners = 0;
    const Json report = Json::parse(scratch.read("report.json"));
    for (const Json& zone : report["report"]["zones"]) {
        pole_corners += zone["pole_corners"].get<std::size_t>();
        CHECK(zone["worst_scaled_jacobian"].get<double>() > 0.1);
    }
    CHECK(pole_corners == poles);
    const Finished check = scratch.shell("cgnscheck -w3 grid.cgns");
    INFO(check.out);
    CHECK(check.out.find("ERROR") == std::string::npos);
    CHECK(check.out.find("WARNING") == std::string::npos);
    return read_cgns(scratch.path() / "grid.cgns");
}

std::string type_of(const MultiblockGrid& grid, const std::string& patch) {
    for (const BoundaryPatch& p : grid.patches) {
        if (p.name == patch) return grid.families[static_cast<std::size_t>(p.family)].type;
    }
    return "no such patch";
}

/// How many nodes of an interface are not the same on its two sides, by the ranges in the file.
int nodes_apart(const MultiblockGrid& grid, const Interface& interface) {
    return not_images(grid, interface, {});
}

/// Lines along j on the two sides of a cut: the angle between their first cells, in degrees, the
/// greatest over the nodes of the cut but its ends.
double greatest_kink(const PointField& x, const Interface& cut) {
    double least = 1;
    for (int i = cut.box.begin[0] + 1; i < cut.box.end[0]; ++i) {
        const Node there = donor_node(cut, {i, 0, 0});
        const Vec3 up = x(i, 1, 0) - x(i, 0, 0);
        const Vec3 down = x(there[0], 0, 0) - x(there[0], 1, 0);
        least = std::min(least, dot(up, down) / (norm(up) * norm(down)));
    }
    return std::acos(least) * 180 / std::acos(-1.0);
}

}  // namespace

TEST_CASE("a C-grid in one face meets itself along its wake, at right angles") {
    const Scratch scratch;
    const MultiblockGrid grid = sound_grid(scratch, "c_grid", 0);
    REQUIRE(grid.zones.size() == 1);
    REQUIRE(grid.interfaces.size() == 1);
    const Interface& wake = grid.interfaces[0];
    CHECK(wake.zone == wake.donor);
    CHECK(wake.box.end[0] - wake.box.begin[0] == 16);
    CHECK(wake.orientation.axes == std::array<int, 3>{-1, -2, 3});
    CHECK(nodes_apart(grid, wake) == 0);
    CHECK(greatest_kink(grid.zones[0].points, wake) < 3);
    const Finished check =
        scratch.hexweave("check " HEXWEAVE_SOURCE_DIR "/tests/cases/good/c_grid.yaml");
    CHECK_THAT(check.out, Catch::Matchers::Contains(
                              "interfaces:\n  wake                     jmin of c, with itself\n"));
}

TEST_CASE("an O-grid in one block meets itself along its seam") {
    const Scratch scratch;
    const MultiblockGrid grid = sound_grid(scratch, "o_block", 0);
    REQUIRE(grid.zones.size() == 1);
    REQUIRE(grid.interfaces.size() == 1);
    const Interface& seam = grid.interfaces[0];
    CHECK(seam.zone == seam.donor);
    CHECK(seam.orientation.axes == std::array<int, 3>{1, 2, 3});
    CHECK((seam.box.begin[0] == 0 && seam.donor_box.begin[0] == 24));
    CHECK(nodes_apart(grid, seam) == 0);
    const Json report = Json::parse(scratch.read("report.json"));
    CHECK(report["report"]["interfaces"][0]["growth"]["ratio"].get<double>() < 1.05);
    const Finished check =
        scratch.hexweave("check " HEXWEAVE_SOURCE_DIR "/tests/cases/good/o_block.yaml");
    CHECK_THAT(check.out,
               Catch::Matchers::Contains("seam                     imin of ring, imax of ring\n"));
}

TEST_CASE("a block round a wing meets itself along its wake") {
    const Scratch scratch;
    const MultiblockGrid grid = sound_grid(scratch, "folded_wing", 0);
    REQUIRE(grid.interfaces.size() == 1);
    const Interface& wake = grid.interfaces[0];
    CHECK(wake.zone == wake.donor);
    // The transform and the ranges, as they stand in the file, on the file's own points.
    const PointField& x = grid.zones[0].points;
    int nodes = 0;
    for (int k = wake.box.begin[2]; k <= wake.box.end[2]; ++k) {
        for (int i = wake.box.begin[0]; i <= wake.box.end[0]; ++i) {
            const Node other = donor_node(wake, {i, 0, k});
            CHECK(x(i, 0, k) == x(other[0], other[1], other[2]));
            CHECK(other[1] == 0);
            CHECK(x(i, 0, k).z == 0);
            ++nodes;
        }
    }
    CHECK(nodes == 7 * 6);
    CHECK(grid.patches.size() == 8);
}

TEST_CASE("a cylinder collapsed to its axis, whose points are on the axis") {
    const Scratch scratch;
    // Four corners of each of the 12 x 6 cells at the axis in either half.
    const MultiblockGrid grid = sound_grid(scratch, "cylinder", std::size_t{4} * 12 * 6 * 2);
    CHECK(type_of(grid, "centre") == "BCDegenerateLine");
    for (const Zone& zone : grid.zones) {
        for (int k = 0; k < 7; ++k) {
            for (int j = 0; j < 13; ++j) {
                CHECK(zone.points(0, j, k).x == 0);
                CHECK(zone.points(0, j, k).y == 0);
                const Vec3 wall = zone.points(8, j, k);
                CHECK(std::hypot(wall.x, wall.y) == Approx(1).epsilon(1e-14));
            }
        }
    }
}

TEST_CASE("an eighth of a ball collapsed to its middle and to its axis") {
    const Scratch scratch;
    // Four corners of the 10 x 8 cells at the middle, and four of the 10 x 6 at the axis; the
    // innermost of these have two of them at the middle.
    const MultiblockGrid grid =
        sound_grid(scratch, "ball", std::size_t{10} * 8 * 4 + std::size_t{10} * 6 * 4 - 10 * 2);
    CHECK(type_of(grid, "middle") == "BCDegeneratePoint");
    CHECK(type_of(grid, "axis") == "BCDegenerateLine");
    const PointField& x = grid.zones[0].points;
    for (int j = 0; j < 9; ++j) {
        for (int i = 0; i < 11; ++i) CHECK(norm(x(i, j, 6)) == Approx(1).epsilon(1e-12));
    }
}

TEST_CASE("the nodes planned are those of the grid, swept or mirrored") {
    const Scratch scratch;
    const std::string square =
        "hexweave: 1\n"
        "vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1]}\n"
        "edges: {south: {from: a, to: b, cells: 4}, west: {from: a, to: d, cells: 3}}\n"
        "faces: {square: {corners: [a, b, c, d]}}\n"
        "boundaries: {wall: {type: BCSymmetryPlane, plane: 'y = 0', sides: [south]}}\n";
    const auto nodes = [&](const std::string& more, std::size_t expected) {
        scratch.write("square.yaml", square + more);
        for (const char* command : {"run", "check"}) {
            const Finished run =
                scratch.hexweave(std::string(command) + " square.yaml --json out.json");
            INFO(more << run.err);
            REQUIRE(run.exit_code == 0);
            const Json json = Json::parse(scratch.read("out.json"));
            CHECK(json["grids"][0]["nodes"] == expected);
            if (!json["report"].is_null()) CHECK(json["report"]["nodes"] == expected);
        }
    };
    nodes("", std::size_t{5} * 4);
    nodes("extrude: {along: [0, 0, 1], cells: 2}\n", std::size_t{5} * 4 * 3);
    nodes("mirror: {at: wall}\n", std::size_t{5} * 4 * 2);
}
