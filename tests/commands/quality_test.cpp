// SPDX-License-Identifier: Apache-2.0
// Gates in the input, and `hexweave quality`, as a user meets them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/commands/program.h"

using namespace hexweave::testing;
using Catch::Contains;

namespace {

/// A parallelogram of 60 degrees whose cells grow by 1.5 along its floor.
std::string slanted(const std::string& require, const std::string& require_of_face = "") {
    return "hexweave: 1\n"
           "vertices: {a: [0, 0], b: [1, 0], c: [1.5, 0.8660254], d: [0.5, 0.8660254]}\n"
           "edges:\n"
           "  floor: {from: a, to: b, cells: 6, spacing: {law: geometric, ratio: 1.5}}\n"
           "  left: {from: a, to: d, cells: 5}\n"
           "faces:\n"
           "  f: {corners: [a, b, c, d], method: algebraic" +
           (require_of_face.empty() ? "" : ", require: " + require_of_face) +
           "}\n"
           "boundaries:\n"
           "  wall: {type: BCWall, sides: [floor, left, b-c, c-d]}\n" +
           (require.empty() ? "" : "require: " + require + "\n");
}

}  // namespace

TEST_CASE("a grid that passes its gates is sound, and the gates are told") {
    const Scratch scratch;
    scratch.write("slant.yaml", slanted("{max_growth: 1.51, min_angle: 59, max_angle: 121}",
                                        "{min_scaled_jacobian: 0.85, max_skewness: 0.34}"));
    const Finished run = scratch.hexweave("run slant.yaml --json out.json");
    INFO(run.out << run.err);
    CHECK(run.exit_code == 0);
    CHECK_THAT(run.out, Contains("gate met: max_growth 1.5, at most 1.51 required"));
    CHECK_THAT(run.out, Contains("gate met: face 'f': min_scaled_jacobian 0.866"));
    const auto json = nlohmann::json::parse(scratch.read("out.json"));
    REQUIRE(json["report"]["gates"].size() == 5);
    for (const auto& gate : json["report"]["gates"]) CHECK(gate["met"] == true);
}

TEST_CASE("a missed gate is named with its place in the file and in the grid, and exits with 1") {
    const Scratch scratch;
    scratch.write("slant.yaml", slanted("{max_growth: 1.3}", "{max_wall_angle: 10}"));
    const Finished run = scratch.hexweave("run slant.yaml");
    INFO(run.out << run.err);
    CHECK(run.exit_code == 1);
    CHECK(scratch.has("slant.cgns"));
    CHECK_THAT(run.out + run.err,
               Contains("gate missed (slant.yaml:10:23): max_growth 1.5, at most 1.3 required, in "
                        "zone 'f' at ("));
    CHECK_THAT(run.out + run.err, Contains("face 'f': max_wall_angle 30, at most 10 required"));
}

TEST_CASE("a gate for which there is nothing to be judged is missed, and says why") {
    const Scratch scratch;
    std::string open = slanted("{max_wall_angle: 89}");
    open.replace(open.find("BCWall"), 6, "BCFarfield");
    scratch.write("slant.yaml", open);
    const Finished run = scratch.hexweave("run slant.yaml --json out.json");
    INFO(run.out << run.err);
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.out, Contains("gate MISSED: max_wall_angle, at most 89 required: nothing to "
                                 "judge, as no boundary of a wall type has nodes off its ends"));
    const auto gate = nlohmann::json::parse(scratch.read("out.json"))["report"]["gates"][0];
    CHECK(gate["met"] == false);
    CHECK(gate["got"].is_null());
}

TEST_CASE("walls of a grid extruded by one cell are judged within its sections") {
    const Scratch scratch;
    scratch.write("slant.yaml",
                  slanted("{max_wall_angle: 10}") + "extrude: {along: [0, 0, 1], cells: 1}\n");
    const Finished run = scratch.hexweave("run slant.yaml");
    INFO(run.out << run.err);
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.out, Contains("gate MISSED: max_wall_angle 30, at most 10 required"));
}

TEST_CASE("first heights between edges are judged against what those ask, at every wall node") {
    const Scratch scratch;
    const auto ogrid = [](const std::string& more) {
        return "hexweave: 1\n"
               "curves: {in: {circle: {center: [0, 0], radius: 1}}, far: {circle: {center: [0, 0], "
               "radius: 10}}}\n"
               "vertices: {a: [1, 0], b: [10, 0]}\n"
               "edges:\n"
               "  wall: {from: a, to: a, along: in, cells: 40}\n"
               "  out: {from: b, to: b, along: far}\n"
               "  cut: {from: a, to: b, cells: 30, spacing: {start: 0.01}}\n"
               "faces: {o: {jmin: -wall, jmax: -out, imin: cut, imax: cut" +
               more +
               "}}\n"
               "boundaries: {wall: {type: BCWall, sides: wall}, far: {type: BCFarfield, sides: "
               "out}}\n"
               "require: {wall_spacing_error: 0.05}\n";
    };
    scratch.write("plain.yaml", ogrid(""));
    const Finished plain = scratch.hexweave("run plain.yaml --json plain.json");
    INFO(plain.out << plain.err);
    CHECK(plain.exit_code == 1);
    CHECK_THAT(plain.out,
               Contains("off those that edges ask at 1 side, the worst face o jmin: 0.25"));
    CHECK_THAT(plain.out, Contains("hint: `heights: {jmin: held}` in face 'o' holds them there"));
    CHECK_THAT(plain.out, Contains("gate MISSED: wall_spacing_error 0.7"));
    CHECK_THAT(plain.out, Contains("note: grid lines bend by up to 9"));
    CHECK_THAT(plain.out, Contains("hint: `orthogonal` at imin of 'o' and imax of 'o'"));
    const auto json = nlohmann::json::parse(scratch.read("plain.json"))["report"];
    CHECK(json["solves"][0]["heights"][0]["held"] == false);
    CHECK(json["interfaces"][0]["bend"] > 80);
    REQUIRE(json["remarks"].size() == 2);
    CHECK(json["remarks"][0]["severity"] == "note");
    CHECK(json["remarks"][1]["hint"] ==
          "`orthogonal` at imin of 'o' and imax of 'o' may straighten them");
    // A missed gate has the node of the wall that is worst.
    CHECK(json["gates"][0]["place"].size() == 3);

    scratch.write("straight.yaml",
                  ogrid(", orthogonal: [imin, imax], heights: {jmin: {height: 0.01}}"));
    const Finished straight = scratch.hexweave("run straight.yaml");
    INFO(straight.out << straight.err);
    CHECK(straight.exit_code == 0);
    CHECK_THAT(straight.out, !Contains("warning"));
    CHECK_THAT(straight.out, Contains("gate met: wall_spacing_error"));

    scratch.write("low.yaml", ogrid(", heights: {jmin: {height: 1e-5}}"));
    const Finished low = scratch.hexweave("run low.yaml");
    INFO(low.out << low.err);
    CHECK(low.exit_code == 1);
    CHECK_THAT(low.err, Contains("warning: face o jmin: heights held are "));
    CHECK_THAT(low.err, Contains("`growth` stops 39 lines"));
    CHECK_THAT(low.err, Contains("what is fixed at its ends is off at 2 nodes"));
    CHECK_THAT(low.err, Contains("hint: more cells off the side"));
}

TEST_CASE(
    "what was asked of heights and not got is a warning: --strict, --quiet and JSON tell it") {
    const Scratch scratch;
    scratch.write("low.yaml",
                  "hexweave: 1\n"
                  "vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1]}\n"
                  "edges: {ab: {from: a, to: b, cells: 8}, ad: {from: a, to: d, cells: 8}}\n"
                  "faces: {f: {corners: [a, b, c, d], heights: {jmin: {height: 1e-4}}}}\n"
                  "boundaries: {all: {type: BCWall, sides: [ab, ad, b-c, c-d]}}\n");
    CHECK(scratch.hexweave("run low.yaml").exit_code == 0);
    const Finished quiet = scratch.hexweave("run low.yaml --quiet");
    CHECK(quiet.exit_code == 0);
    CHECK_THAT(quiet.err, Contains("warning: face f jmin: heights held are "));
    const Finished strict = scratch.hexweave("run low.yaml --strict --json low.json");
    CHECK(strict.exit_code == 1);
    const auto remarks = nlohmann::json::parse(scratch.read("low.json"))["report"]["remarks"];
    REQUIRE(!remarks.empty());
    CHECK(remarks[0]["severity"] == "warning");
}

TEST_CASE("gates of a wall face in a grid of blocks judge its wall, and all tell their place") {
    const Scratch scratch;
    scratch.write("box.yaml",
                  "hexweave: 1\n"
                  "vertices: {a: [0, 0, 0], b: [1, 0, 0], c: [1.3, 1, 0], d: [0.2, 1, 0],\n"
                  "           e: [0, 0, 1], f: [1, 0, 1.2], g: [1, 1.1, 1], h: [0, 1, 1]}\n"
                  "edges:\n"
                  "  ab: {from: a, to: b, cells: 8}\n"
                  "  ad: {from: a, to: d, cells: 8}\n"
                  "  ae: {from: a, to: e, cells: 8, spacing: {start: 0.02}}\n"
                  "faces:\n"
                  "  floor: {corners: [a, b, c, d], require: {max_wall_angle: 45, min_angle: 20, "
                  "max_angle: 160, wall_spacing_error: 0.5}}\n"
                  "  lid: {corners: [e, f, g, h], require: {max_wall_angle: 45}}\n"
                  "blocks: {box: {corners: [a, b, c, d, e, f, g, h]}}\n"
                  "boundaries: {wall: {type: BCWall, sides: [floor]}}\n");
    const Finished run = scratch.hexweave("run box.yaml --json box.json");
    INFO(run.out << run.err);
    CHECK(run.exit_code == 1);  // the lid is no wall
    const auto gates = nlohmann::json::parse(scratch.read("box.json"))["report"]["gates"];
    REQUIRE(gates.size() == 5);
    for (const auto& gate : gates) {
        INFO(gate.dump());
        const bool of_lid = gate["subject"] == "face 'lid'";
        CHECK(gate["met"] == !of_lid);
        CHECK(gate["place"].is_null() == of_lid);
    }
}

TEST_CASE("no hint asks of a sweep what faces alone have") {
    const Scratch scratch;
    scratch.write("turn.yaml",
                  "hexweave: 1\n"
                  "vertices: {a: [1, 0], b: [2, 0], c: [2, 1], d: [1, 1]}\n"
                  "edges: {ab: {from: a, to: b, cells: 6}, ad: {from: a, to: d, cells: 6}}\n"
                  "faces: {f: {corners: [a, b, c, d]}}\n"
                  "boundaries: {all: {type: BCWall, sides: [ab, ad, b-c, c-d]}}\n"
                  "revolve: {angle: 2 * pi, cells: 6, axis: [0, 1, 0]}\n");
    const Finished turn = scratch.hexweave("run turn.yaml");
    INFO(turn.out << turn.err);
    CHECK_THAT(turn.out, Contains("note: grid lines bend by up to 60 degrees across"));
    CHECK_THAT(turn.out, !Contains("may straighten"));
}

TEST_CASE("quality judges a grid of another's making and says so by its exit code") {
    const Scratch scratch;
    const std::string grid = HEXWEAVE_SOURCE_DIR "/tests/io/grids/n0012_113-33.p2d";
    const Finished sound = scratch.hexweave("quality '" + grid + "' --json quality.json");
    CHECK(sound.exit_code == 0);
    CHECK_THAT(sound.out, Contains("Jacobian positive everywhere inside: 3584 of 3584 cells"));
    CHECK_THAT(sound.out, Contains("sound: 1 zone, 3,584 cells, none folded"));
    CHECK(nlohmann::json::parse(scratch.read("quality.json"))["folded"] == 0);

    // Two columns of cells, the second on the wrong side of the first.
    scratch.write("folded.p2d", "1\n3 2\n0 2 1 0 2 1\n0 0 0 1 1 1\n");
    const Finished folded = scratch.hexweave("quality folded.p2d");
    INFO(folded.out << folded.err);
    CHECK(folded.exit_code == 1);
    CHECK_THAT(folded.out, Contains("NOT SOUND: 1 folded cell, 1 cell with a Jacobian that is not "
                                    "positive somewhere, the worst in 'block1' at (1.5, 0.5, 0)"));

    CHECK(scratch.hexweave("quality nowhere.cgns").exit_code == 2);
}

TEST_CASE("damaged grids are one message and exit 2, whatever is done with them") {
    const Scratch scratch;
    scratch.write("text.cgns", "not a grid\n");
    const std::string golden = slurp(HEXWEAVE_SOURCE_DIR "/tests/goldens/scherk.cgns");
    scratch.write("cut.cgns", golden.substr(0, golden.size() / 2));
    scratch.write("cut.p2d", "1\n3 2\n0 1 2 0 1\n");
    scratch.write("nan.p2d", "1\n3 2\n0 1 2 0 nan 2\n0 0 0 1 1 1\n");
    scratch.write("mapped.p2d", "1\n3 2\n0 1 2 0 1 2\n0 0 0 1 1 1\n");
    scratch.write("mapped.nmf", "1\n1 3 3 1\n");
    const std::string before = scratch.listing();
    for (const std::string grid : {"text.cgns", "cut.cgns", "cut.p2d", "nan.p2d", "mapped.p2d"}) {
        for (const std::string& command :
             {"quality " + grid, "quality " + grid + " --json -", "plot " + grid + " -o grid.png",
              "convert " + grid + " grid.cgns", "convert " + grid + " grid.vtm"}) {
            const Finished run = scratch.hexweave(command);
            INFO(command << ": " << run.err);
            CHECK(run.exit_code == 2);
            CHECK(run.out.empty());
            CHECK_THAT(run.err, Contains("hexweave: error: "));
            CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
            CHECK_THAT(run.err, Contains(grid.substr(0, grid.find('.'))));
        }
    }
    CHECK(scratch.listing() == before);
}
