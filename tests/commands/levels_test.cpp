// SPDX-License-Identifier: Apache-2.0
// Counts that are not as written: families of grids, and multiples.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/every_nth.h"
#include "io/cgns.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;
using Json = nlohmann::json;

namespace {

bool same_bits(const PointField& a, const PointField& b) {
    if (!(a.extent() == b.extent())) return false;
    for (std::size_t n = 0; n < a.extent().nodes(); ++n) {
        if (!(a[n] == b[n])) return false;
    }
    return true;
}

/// Nodes of a zone at which its grid is not every second one of a finer grid's zone.
void check_nested(const MultiblockGrid& coarse, const MultiblockGrid& fine) {
    REQUIRE(coarse.zones.size() == fine.zones.size());
    for (std::size_t z = 0; z < fine.zones.size(); ++z) {
        INFO(fine.zones[z].name);
        CHECK(coarse.zones[z].name == fine.zones[z].name);
        CHECK(same_bits(coarse.zones[z].points, every_nth(fine.zones[z].points, 2)));
    }
    REQUIRE(coarse.interfaces.size() == fine.interfaces.size());
    for (std::size_t i = 0; i < fine.interfaces.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            CHECK(2 * coarse.interfaces[i].box.end[axis] == fine.interfaces[i].box.end[axis]);
        }
    }
    CHECK(coarse.patches.size() == fine.patches.size());
}

/// A shipped case with more keys.
void write_with(const Scratch& scratch, const std::string& name, const std::string& keys) {
    std::string text = slurp(shipped(name));
    text.insert(text.find("hexweave: 1\n") + 12, keys + "\n");
    scratch.write(name, text);
}

/// An airfoil-like bump with cells at a wall, heights held there, a composed side.
const std::string channel = R"(hexweave: 1
parameters: {wall: 1e-3}
curves: {hump: {formula: [t, 0.1 * sin(pi * t)^2], range: [0, 1]}}
vertices: {a: [0, 0], b: [1, 0], m: [0.5, 0.1], c: [1, 1], d: [0, 1]}
edges:
  floor1: {from: a, to: m, along: hump, cells: 11}
  floor2: {from: m, to: b, along: hump, cells: 9}
  left: {from: a, to: d, cells: 15, spacing: {start: wall}}
faces:
  channel: {imin: left, imax: right, jmin: [floor1, floor2], jmax: top, orthogonal: jmin,
            heights: {jmin: held}}
boundaries:
  wall: {type: BCWallViscous, sides: [floor1, floor2]}
  rest: {type: BCFarfield, sides: [left, right, top]}
)";

std::string channel_with(const std::string& keys) {
    std::string text = channel;
    text.insert(12, keys + "\n");
    text.insert(text.find("faces:"), "  right: {from: b, to: c}\n  top: {from: d, to: c}\n");
    return text;
}

}  // namespace

TEST_CASE("at a factor 2 the levels are nested to the bit, in two dimensions") {
    const Scratch scratch;
    write_with(scratch, "naca0012.yaml", "levels: {names: [coarse, medium, fine]}");
    const Finished all = scratch.hexweave(
        "run naca0012.yaml --level all --set around=16 --set normal=32 --json all.json");
    INFO(all.err);
    CHECK(all.exit_code == 0);
    const auto grid = [&](const std::string& level) {
        return read_cgns(scratch.path() / ("naca0012." + level + ".cgns"));
    };
    check_nested(grid("coarse"), grid("medium"));
    check_nested(grid("medium"), grid("fine"));
    CHECK(grid("medium").zones[0].points.extent() == Extent{17, 33, 1});
    CHECK(grid("fine").provenance.find("; level fine") != std::string::npos);

    // A level made alone is the same file; no level asked for: the file's own, medium.
    CHECK(scratch
              .hexweave("run naca0012.yaml --level coarse -o c.cgns --set around=16 "
                        "--set normal=32")
              .exit_code == 0);
    CHECK(scratch.read("c.cgns") == scratch.read("naca0012.coarse.cgns"));
    CHECK(scratch.hexweave("run naca0012.yaml --set around=16 --set normal=32").exit_code == 0);
    CHECK(scratch.read("naca0012.cgns") == scratch.read("naca0012.medium.cgns"));

    const Json json = Json::parse(scratch.read("all.json"));
    REQUIRE(json["levels"].size() == 3);
    CHECK(json["report"] == json["levels"][2]);
    CHECK(json["levels"][0]["level"] ==
          Json::parse(R"({"name": "coarse", "factor": 2.0, "names": ["coarse", "medium", "fine"],
                          "solved": "fine", "stride": 4})"));
    CHECK(json["grids"][0]["cells"].get<int>() * 16 == json["grids"][2]["cells"].get<int>());
    CHECK(json["grids"][0]["memory"] == json["grids"][2]["memory"]);  // the finest is solved
}

TEST_CASE("the growth and the asked cells of nested levels are reported") {
    const Scratch scratch;
    scratch.write("channel.yaml", channel_with("levels: {}"));
    const Finished all = scratch.hexweave("run channel.yaml --level all --json all.json");
    INFO(all.out << all.err);
    CHECK(all.exit_code == 0);
    CHECK(all.out.find("level coarse of coarse, medium, fine, factor 2: every 4th point of level "
                       "fine, which is solved\n") != std::string::npos);
    CHECK(all.out.find("first and last cells are asked, and got, at level medium\n") !=
          std::string::npos);
    CHECK(all.out.find("family           cells per line |  growth, lines   across") !=
          std::string::npos);
    // 15 and 11 and 9 have no half: raised, the side opposite with them.
    CHECK(all.out.find("  left                             15         15         16\n") !=
          std::string::npos);
    const Json levels = Json::parse(scratch.read("all.json"))["levels"];
    for (const Json& level : levels) {
        const Json& left = level["spacings"][2];
        CHECK(left["edge"] == "left");
        CHECK(left["first_got"].get<double>() == Approx(1e-3).epsilon(1e-9));
    }
    const auto first = [&](std::size_t level) {
        return levels[level]["spacings"][2]["first"].get<double>();
    };
    CHECK(first(1) == Approx(1e-3).epsilon(1e-9));
    CHECK(first(0) > 2e-3);  // two cells of medium, the second larger
    CHECK(first(2) < 5e-4);  // the smaller part of one
    const auto growth = [&](std::size_t level) {
        return levels[level]["zones"][0]["growth"][1]["ratio"].get<double>();
    };
    // Growth from cell to cell compounds over the two that become one.
    CHECK(growth(0) > growth(1));
    CHECK(growth(1) > growth(2));
    CHECK(growth(2) > 1);
    for (const Json& level : levels) {
        const Json& held = level["solves"][0]["heights"][0];
        CHECK(held["median"].get<double>() == Approx(1).epsilon(0.05));
    }
}

TEST_CASE("at a factor 2 the levels of blocks are nested to the bit") {
    const Scratch scratch;
    write_with(scratch, "pipe.yaml", "levels: {names: [medium, fine]}");
    const Finished all = scratch.hexweave(
        "run pipe.yaml --level all --set across=6 --set radial=8 --set along=6 -o p.cgns -o p.vtm");
    INFO(all.err);
    CHECK(all.exit_code == 0);
    check_nested(read_cgns(scratch.path() / "p.medium.cgns"),
                 read_cgns(scratch.path() / "p.fine.cgns"));
    CHECK(scratch.listing() ==
          "p.fine p.fine.cgns p.fine.vtm p.medium p.medium.cgns p.medium.vtm pipe.yaml");
}

TEST_CASE("at a factor of 1.5 each level is solved, its cells at the wall scaled") {
    const Scratch scratch;
    scratch.write("channel.yaml", channel_with("levels: {factor: 1.5}\nlevel: fine"));
    const Finished run = scratch.hexweave("run channel.yaml --json fine.json");
    INFO(run.out << run.err);
    CHECK(run.exit_code == 0);
    CHECK(run.out.find("level fine of coarse, medium, fine, factor 1.5: solved itself\n") !=
          std::string::npos);
    const Json report = Json::parse(scratch.read("fine.json"))["report"];
    CHECK(report["zones"][0]["nodes"] == Json{17 + 14 + 1, 23 + 1, 1});  // of 16.5, 13.5, 22.5
    CHECK(report["spacings"][2]["first_asked"].get<double>() == Approx(1e-3 / 1.5));
    CHECK(report["spacings"][2]["first_got"].get<double>() == Approx(1e-3 / 1.5).epsilon(1e-9));
    CHECK(scratch.listing() == "channel.cgns channel.yaml fine.json");
    CHECK(scratch.hexweave("run channel.yaml --level coarse").exit_code == 0);
    CHECK(scratch.has("channel.coarse.cgns"));
    const Finished all = scratch.hexweave("check channel.yaml --level all");
    CHECK(all.out.find("level medium of coarse, medium, fine, factor 1.5: solved itself\n5 "
                       "vertices, 5 edges, 1 faces, 0 blocks; 300 cells\n") != std::string::npos);
}

TEST_CASE("multiples hold at every level, and it is explained") {
    const Scratch scratch;
    scratch.write("channel.yaml", channel_with("levels: {}\nmultiple_of: 4"));
    const Finished check = scratch.hexweave("check channel.yaml --level coarse --explain left");
    INFO(check.out << check.err);
    CHECK(check.out.find("15 cells: said here\n") != std::string::npos);
    CHECK(check.out.find("at level 'coarse' 0.5 times as many: 7.5\n") != std::string::npos);
    CHECK(check.out.find("raised from 7.5 to 8\n") != std::string::npos);
    CHECK(check.out.find("channel.yaml:3     a multiple of 4 is asked for here\n") !=
          std::string::npos);
}

TEST_CASE("cells raised to a multiple are listed by check, by run and in the JSON") {
    const Scratch scratch;
    scratch.write("step.yaml", R"(hexweave: 1
multiple_of: 8
vertices: {a: [0, 0], m: [1, 0], b: [3, 0], c: [3, 1], d: [0, 1]}
edges:
  low1: {from: a, to: m, cells: 16}
  low2: {from: m, to: b, cells: 17}
  high: {from: d, to: c}
  west: {from: a, to: d, cells: 8, spacing: {start: 0.01}}
  east: {from: b, to: c}
faces:
  f: {imin: west, imax: east, jmin: [low1, low2], jmax: high}
boundaries:
  all: {type: BCWall, sides: [low1, low2, high, west, east]}
)");
    const std::string list =
        "cells raised, of edge         written      asked        got\n"
        "  low2                             17         17         24\n"
        "  high                             33         33         40\n";
    const Finished check = scratch.hexweave("check step.yaml --json check.json");
    CHECK(check.exit_code == 0);
    CHECK(check.out.find(list) != std::string::npos);
    const Finished run = scratch.hexweave("run step.yaml --json run.json");
    CHECK(run.exit_code == 0);
    CHECK(run.out.find(list) != std::string::npos);
    for (const char* file : {"check.json", "run.json"}) {
        const Json grids = Json::parse(scratch.read(file))["grids"];
        REQUIRE(grids.size() == 1);
        CHECK(grids[0]["cells"] == 40 * 8);
        CHECK(grids[0]["nodes"] == 41 * 9);
        CHECK(grids[0]["memory"] > 41 * 9 * 48);
        CHECK(grids[0]["adjusted_counts"] ==
              Json::parse(R"([{"edge": "low2", "written": 17, "asked": 17.0, "got": 24},
                              {"edge": "high", "written": 33, "asked": 33.0, "got": 40}])"));
    }
    const Json report = Json::parse(scratch.read("run.json"))["report"];
    CHECK(report["zones"][0]["nodes"] == Json{41, 9, 1});
    CHECK(report["spacings"][3]["first_got"].get<double>() == Approx(0.01).epsilon(1e-9));
}
