// SPDX-License-Identifier: Apache-2.0
// What ends folded or unconverged is said, and can be looked at alone.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/commands/program.h"

using namespace hexweave::testing;
using nlohmann::json;

namespace {

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

/// What VTK finds in a file; "skipped: ..." where there is no VTK.
std::string seen_by_vtk(const Scratch& scratch, const std::string& file) {
    return scratch
        .shell("/usr/bin/python3 " HEXWEAVE_SOURCE_DIR "/tests/tools/vtk_cells.py " + file)
        .out;
}

}  // namespace

TEST_CASE("a face that stays folded is written alone, and named everywhere") {
    const Scratch scratch;
    scratch.write("bow.yaml", folded_by_its_boundary);
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
    CHECK(folded > 0);
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

TEST_CASE("files of an earlier run's offenders go, and nothing else does") {
    const Scratch scratch;
    scratch.write("box.yaml", bent_box);
    CHECK(scratch.hexweave("run box.yaml --set cycles=1 --quiet").exit_code == 1);
    CHECK(scratch.has("box.offenders/block-box.vts"));
    scratch.write("box.offenders/face-old.vts", "of a face that is no more");
    CHECK(scratch.hexweave("run box.yaml --set cycles=1 --quiet").exit_code == 1);
    CHECK(scratch.has("box.offenders/block-box.vts"));
    CHECK(!scratch.has("box.offenders/face-old.vts"));

    // A run that fails leaves them.
    scratch.write("bad.yaml", "hexweave: 1\n");
    CHECK(scratch.hexweave("run bad.yaml -o box.cgns").exit_code == 2);
    CHECK(scratch.has("box.offenders/block-box.vts"));

    // What the program does not write stays, and with it the folder.
    scratch.write("box.offenders/notes.txt", "mine");
    scratch.write("box.offenders/my.vts", "mine");
    std::filesystem::create_directory(scratch.path() / "box.offenders/face-mine.vts");
    std::filesystem::create_symlink(scratch.path() / "box.yaml",
                                    scratch.path() / "box.offenders/face-link.vts");
    CHECK(scratch.hexweave("run box.yaml --quiet").exit_code == 0);
    CHECK(!scratch.has("box.offenders/block-box.vts"));
    CHECK(scratch.read("box.offenders/notes.txt") == "mine");
    CHECK(scratch.read("box.offenders/my.vts") == "mine");
    CHECK(scratch.has("box.offenders/face-mine.vts"));
    CHECK(scratch.has("box.offenders/face-link.vts"));
    CHECK(scratch.has("box.yaml"));

    std::filesystem::remove_all(scratch.path() / "box.offenders");
    CHECK(scratch.hexweave("run box.yaml --set cycles=1 --quiet").exit_code == 1);
    CHECK(scratch.hexweave("run box.yaml --quiet").exit_code == 0);
    CHECK(scratch.listing() == "bad.yaml box.cgns box.yaml");
}

TEST_CASE("a face that folds as a surface is told, though no cell of its block is folded") {
    const Scratch scratch;
    // Two of its sides are darts: each has a corner that its neighbours turn inwards.
    scratch.write("dart.yaml", R"(hexweave: 1
vertices: {a: [-0.28, 0.43, -0.52], b: [1.28, -0.12, 0.09], c: [0.57, 0.31, -0.26], d: [0.04, 1.32, 0.18],
           e: [0.64, -0.29, 0.92], f: [1.45, 0.46, 1.38], g: [1.21, 1.67, 0.56], h: [-0.6, 0.76, 1.52]}
edges: {ab: {from: a, to: b, cells: 1}, ad: {from: a, to: d, cells: 1}, ae: {from: a, to: e, cells: 1}}
blocks: {box: {corners: [a, b, c, d, e, f, g, h]}}
boundaries: {all: {type: BCWall, sides: [a-b-c-d, e-f-g-h, a-b-f-e, d-c-g-h, a-d-h-e, b-c-g-f]}}
)");
    const Finished run = scratch.hexweave("run dart.yaml");
    CHECK(run.exit_code == 0);
    CHECK(contains(run.out, "\nsound: 1 zone, 1 cell, none folded"));
    CHECK(contains(run.err,
                   "warning: face 'a-b-c-d' folds as a surface, in 1 cell at (-0.28, 0.43, -0.52); "
                   "no cell of the blocks is folded\n"));
    CHECK(contains(run.out, "see dart.offenders/face-a-b-c-d.vts"));
    CHECK(scratch.hexweave("run dart.yaml --strict").exit_code == 1);
    const Finished quiet = scratch.hexweave("run dart.yaml --quiet");
    CHECK(contains(quiet.err, "warning: face 'a-b-c-d' folds"));
}
