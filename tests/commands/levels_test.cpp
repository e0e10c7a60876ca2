// SPDX-License-Identifier: Apache-2.0
// Counts that are not as written: multiples.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/commands/program.h"

using namespace hexweave::testing;
using Json = nlohmann::json;

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
