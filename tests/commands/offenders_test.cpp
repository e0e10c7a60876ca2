// SPDX-License-Identifier: Apache-2.0
// What ends folded or unconverged is said, and can be looked at alone.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/commands/program.h"

using namespace hexweave::testing;
using nlohmann::json;

namespace {

/// An outline that crosses itself: no grid of it is sound.
const std::string bow_tie = R"(hexweave: 1
units: m
vertices: {a: [0, 0], b: [1, 0], c: [0.2, 1], d: [0.8, 1.4]}
edges:
  south: {from: a, to: b, cells: 8}
  west: {from: a, to: d, cells: 6}
faces:
  tie: {corners: [a, b, c, d]}
boundaries:
  rim: {type: BCWall, sides: [south, west, b-c, c-d]}
)";

/// A face with an outline of its own, in a block whose floor is bent.
const std::string bent_box = R"(hexweave: 1
parameters: {cycles: 200}
curves:
  wave: {formula: [t, 0, 0.4 * sin(2 * pi * t)], range: [0, 1]}
vertices:
  {a: [0, 0, 0], b: [1, 0, 0], c: [1, 1, 0], d: [0, 1, 0], e: [0, 0, 1], f: [1, 0, 1], g: [1, 1, 1], h: [0, 1, 1]}
edges:
  front: {from: a, to: b, along: wave, cells: 12}
  left: {from: a, to: d, cells: 9}
  up: {from: a, to: e, cells: 10, spacing: {start: 0.02}}
blocks:
  box: {corners: [a, b, c, d, e, f, g, h]}
boundaries:
  rim: {type: BCWall, sides: [a-b-c-d, e-f-g-h, a-b-f-e, d-c-g-h, a-d-h-e, b-c-g-f]}
solver: {maximum_cycles: cycles}
)";

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// What VTK finds in a file; "skipped: ..." where there is no VTK.
std::string seen_by_vtk(const Scratch& scratch, const std::string& file) {
    return scratch
        .shell("/usr/bin/python3 " HEXWEAVE_SOURCE_DIR "/tests/tools/vtk_cells.py " + file)
        .out;
}

}  // namespace

TEST_CASE("a face that stays folded is written alone, and named everywhere") {
    const Scratch scratch;
    scratch.write("bow.yaml", bow_tie);
    const Finished run = scratch.hexweave("run bow.yaml --json run.json");
    CHECK(run.exit_code == 1);
    CHECK(contains(run.out, "face 'tie' could not be untangled"));
    CHECK(
        contains(run.out, "\nsee bow.offenders/face-tie.vts for the worst cells of face 'tie'\n"));
    const json outcome = json::parse(scratch.read("run.json"));
    CHECK(
        outcome["offenders"] ==
        json::array({{{"name", "tie"}, {"kind", "face"}, {"file", "bow.offenders/face-tie.vts"}}}));
    CHECK(scratch.listing() == "bow.cgns bow.offenders bow.yaml run.json");

    const std::string seen = seen_by_vtk(scratch, "bow.offenders/face-tie.vts");
    if (contains(seen, "skipped:")) {
        WARN(seen);
        return;
    }
    const auto folded = outcome["report"]["folded"].get<int>();
    CHECK(folded > 10);
    CHECK(contains(seen, "9x7x1 face tie cells=48 folded=" + std::to_string(folded) + " "));
    // The worst cell of the report is the one that is marked first.
    const auto& zone = outcome["report"]["zones"][0];
    const int cell =
        zone["worst_cell"][0].get<int>() - 1 + 8 * (zone["worst_cell"][1].get<int>() - 1);
    CHECK(contains(seen, " worst=" + std::to_string(cell) + ","));
}

TEST_CASE("faces within a grid of blocks are offenders as well") {
    const Scratch scratch;
    scratch.write("box.yaml", bent_box);
    const Finished run = scratch.hexweave("run box.yaml --set cycles=1 --quiet --json run.json");
    CHECK(run.exit_code == 1);
    CHECK(run.out.empty());
    CHECK(contains(run.err, "see box.offenders/face-a-b-c-d.vts"));
    bool face = false;
    bool block = false;
    const json outcome = json::parse(scratch.read("run.json"));
    for (const auto& offender : outcome["offenders"]) {
        face |= offender["kind"] == "face" && offender["name"] == "a-b-c-d";
        block |= offender["kind"] == "block" && offender["name"] == "box";
        CHECK(scratch.has(offender["file"].get<std::string>()));
    }
    CHECK(face);
    CHECK(block);
    for (const auto& solve : outcome["report"]["solves"]) {
        CHECK(solve["kept_cycle"].is_null() == (solve["status"] == "converged"));
    }
    const std::string seen = seen_by_vtk(scratch, "box.offenders/block-box.vts");
    if (contains(seen, "skipped:")) {
        WARN(seen);
        return;
    }
    CHECK(contains(seen, "13x10x11 block box cells=1080 folded=0 "));
    // The cell that VTK finds the worst is the first of those marked.
    const std::string least = seen.substr(seen.find("least=") + 6);
    CHECK(contains(seen, " worst=" + least.substr(0, least.find(' ')) + ","));
}

TEST_CASE("a sound grid leaves no file of offenders") {
    const Scratch scratch;
    scratch.write("box.yaml", bent_box);
    CHECK(scratch.hexweave("run box.yaml --quiet").exit_code == 0);
    CHECK(scratch.listing() == "box.cgns box.yaml");
}
