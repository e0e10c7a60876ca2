// SPDX-License-Identifier: Apache-2.0
// Counts that are not as written: families of grids, and multiples.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/every_nth.h"
#include "core/periodic_image.h"
#include "io/cgns.h"
#include "tests/commands/images.h"
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

/// The plane k of a grid.
PointField plane_of(const PointField& points, int k) {
    const Extent& extent = points.extent();
    PointField plane({extent.ni, extent.nj, 1});
    for (int j = 0; j < extent.nj; ++j) {
        for (int i = 0; i < extent.ni; ++i) plane.set(i, j, 0, points(i, j, k));
    }
    return plane;
}

/// Checks that a grid is every second node of a finer one along each axis; along k every node where
/// both are a sweep by one cell.
void check_nested(const MultiblockGrid& coarse, const MultiblockGrid& fine) {
    REQUIRE(coarse.zones.size() == fine.zones.size());
    const bool single = fine.zones[0].points.extent().nk == 2;
    for (std::size_t z = 0; z < fine.zones.size(); ++z) {
        INFO(fine.zones[z].name);
        CHECK(coarse.zones[z].name == fine.zones[z].name);
        const PointField& own = coarse.zones[z].points;
        const PointField& finer = fine.zones[z].points;
        for (int k = 0; single && k < 2; ++k) {
            CHECK(same_bits(plane_of(own, k), every_nth(plane_of(finer, k), 2)));
        }
        if (!single) CHECK(same_bits(own, every_nth(finer, 2)));
    }
    REQUIRE(coarse.interfaces.size() == fine.interfaces.size());
    for (std::size_t i = 0; i < fine.interfaces.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int step = single && axis == 2 ? 1 : 2;
            CHECK(step * coarse.interfaces[i].box.end[axis] == fine.interfaces[i].box.end[axis]);
        }
    }
    CHECK(coarse.patches.size() == fine.patches.size());
}

/// Grids of all levels of a config, each nested in the next and sound, its interfaces exact.
std::vector<MultiblockGrid> nested_levels(const Scratch& scratch, const std::string& config,
                                          const std::string& options = "") {
    const Finished all = scratch.hexweave("run " + config +
                                          ".yaml --level all -o g.cgns --json "
                                          "all.json" +
                                          options);
    INFO(all.out << all.err);
    REQUIRE(all.exit_code == 0);
    std::vector<MultiblockGrid> grids;
    const Json levels = Json::parse(scratch.read("all.json"))["levels"];
    for (const Json& level : levels) {
        const std::string name = level["level"]["name"];
        INFO(name);
        for (const Json& interface : level["interfaces"]) {
            CHECK(interface["mismatched"] == 0);
        }
        grids.push_back(read_cgns(scratch.path() / ("g." + name + ".cgns")));
        if (grids.size() > 1) check_nested(grids[grids.size() - 2], grids.back());
    }
    CHECK(grids.size() == 3);
    return grids;
}

/// A good case of the tests, at levels and with one text put for another.
void write_good(const Scratch& scratch, const std::string& name, const std::string& old = "",
                const std::string& with = "") {
    std::string text = slurp(HEXWEAVE_SOURCE_DIR "/tests/cases/good/" + name + ".yaml");
    text.insert(text.find("hexweave: 1\n") + 12, "levels: {}\n");
    if (!old.empty()) text.replace(text.find(old), old.size(), with);
    scratch.write(name + ".yaml", text);
}

/// A shipped case with more keys.
void write_with(const Scratch& scratch, const std::string& name, const std::string& keys) {
    scratch.write(name, shipped_with(name, "hexweave: 1\n", keys + "\n"));
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

TEST_CASE("layers of a revolution follow the levels, to the bit") {
    const Scratch scratch;
    write_good(scratch, "revolved_channel");
    const auto grids = nested_levels(scratch, "revolved_channel");
    for (std::size_t n = 0; n < 3; ++n) {
        CHECK(grids[n].zones[0].points.extent().nk == (4 << n) + 1);
    }
    const Finished check = scratch.hexweave("check revolved_channel.yaml --level coarse");
    CHECK(check.out.find("through [0, 0], 4 cells, from bottom to side\n") != std::string::npos);
}

TEST_CASE("layers are raised to what the levels and multiples need, visibly") {
    const Scratch scratch;
    write_good(scratch, "revolved_channel", "cells: 8, start: bottom", "cells: 7, start: bottom");
    const auto grids = nested_levels(scratch, "revolved_channel");
    CHECK(grids[1].zones[0].points.extent().nk == 9);
    const Finished check = scratch.hexweave("check revolved_channel.yaml --json check.json");
    CHECK(check.out.find("  layers of the sweep               7          7          8\n") !=
          std::string::npos);
    const Json list = Json::parse(scratch.read("check.json"))["grids"][0]["adjusted_counts"];
    REQUIRE(list.size() == 1);
    CHECK(list[0]["edge"] == "layers of the sweep");
    CHECK(list[0]["got"] == 8);
}

TEST_CASE("layers of an extrusion keep their law, and a mirrored grid its image, at every level") {
    const Scratch scratch;
    write_good(scratch, "extruded_bump", "along: [0, 0, 0.1],",
               "along: [0, 0, 0.1], cells: 6, spacing: {start: 0.004},");
    const auto grids = nested_levels(scratch, "extruded_bump");
    const PointField& medium = grids[1].zones[0].points;
    REQUIRE(medium.extent().nk == 7);
    CHECK(medium.z(0, 0, 1) == Approx(0.004).epsilon(1e-9));
    for (const MultiblockGrid& grid : grids) {
        const PointField& own = grid.zones[0].points;
        const PointField& image = grid.zones[1].points;
        CHECK(image.extent().nk == own.extent().nk);
        CHECK(image.z(0, 0, 1) == own.z(0, 0, 1));
    }
}

TEST_CASE("a sweep by one cell is one cell at every level") {
    const Scratch scratch;
    write_good(scratch, "extruded_bump");
    for (const MultiblockGrid& grid : nested_levels(scratch, "extruded_bump")) {
        CHECK(grid.zones[0].points.extent().nk == 2);
    }
    const Finished check = scratch.hexweave("check extruded_bump.yaml --level fine");
    CHECK(check.out.find("translation [0, 0, 0.1], 1 cell at every level, from slices") !=
          std::string::npos);
}

TEST_CASE("at a factor of 1.5 layers are scaled and raised to whole ones") {
    const Scratch scratch;
    std::string text = slurp(HEXWEAVE_SOURCE_DIR "/tests/cases/good/extruded_bump.yaml");
    text.insert(text.find("hexweave: 1\n") + 12, "levels: {factor: 1.5}\n");
    text.replace(text.find("along: [0, 0, 0.1],"), 19,
                 "along: [0, 0, 0.1], cells: 5, spacing: {start: 0.006},");
    scratch.write("bump.yaml", text);
    CHECK(scratch.hexweave("run bump.yaml --level fine").exit_code == 0);
    const PointField fine = read_cgns(scratch.path() / "bump.fine.cgns").zones[0].points;
    CHECK(fine.extent().nk == 9);  // of 7.5
    CHECK(fine.z(0, 0, 1) == Approx(0.004).epsilon(1e-9));
}

TEST_CASE("periodic sides are exact images at every level") {
    const Scratch scratch;
    const double pitch = 2 * std::numbers::pi / 18;
    for (const auto& [name, periodicity] :
         {std::pair("periodic_channel", Periodicity{{}, {}, {0, 0.7, 0}}),
          std::pair("annular_sector", Periodicity{{}, {pitch, 0, 0}, {}})}) {
        write_good(scratch, name);
        for (const MultiblockGrid& grid : nested_levels(scratch, name)) {
            int periodic = 0;
            for (const Interface& interface : grid.interfaces) {
                if (!interface.periodic) continue;
                ++periodic;
                CHECK(not_images(grid, interface, periodic_map(periodicity)) == 0);
            }
            CHECK(periodic == 2);
        }
    }
}

TEST_CASE("instances of a component are nested at every level") {
    const Scratch scratch;
    write_with(scratch, "cascade.yaml", "levels: {}");
    const auto grids = nested_levels(scratch, "cascade", " --set cells=12");
    CHECK(grids[0].zones.size() == 30);
}
