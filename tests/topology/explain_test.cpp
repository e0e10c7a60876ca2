// SPDX-License-Identifier: Apache-2.0
// What `check --explain` tells: every step with its line.
#include <catch2/catch.hpp>
#include <string>

#include "topology/explain.h"
#include "topology/read_case.h"
#include "topology/resolve.h"

using namespace hexweave;

namespace {

const std::string strip = R"(hexweave: 1
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 6, spacing: {start: 0.01}}
  right: {from: b2, to: a2, spacing: {like: -left}}
  top: {from: b0, to: b2}
  low1: {from: a0, to: a1, cells: 5}
  low2: {from: a1, to: a2, cells: 2}
faces:
  whole: {imin: left, imax: right, jmin: [low1, low2], jmax: top}
boundaries:
  wall: {type: BCWall, sides: [low1, low2, left, right, top]}
)";

std::string explained(const std::string& text, const std::string& name) {
    const auto source = std::make_shared<const SourceFile>(SourceFile{"s", text});
    Diagnostics diagnostics;
    const Case written = read_case(source, {}, diagnostics);
    const Topology topology = resolve(written, diagnostics);
    std::string all;
    for (const Explanation& e : explain(written, topology, name)) all += to_text(e);
    return all;
}

}  // namespace

TEST_CASE("An edge like another tells whose fractions it has, and across what its count came") {
    CHECK(explained(strip, "right") == R"(edge 'right'
  s:5   runs from vertex 'b2' [2, 1] to vertex 'a2' [2, 0]: a straight line, length 1
  s:5   6 cells: as edge 'left'
  s:10    across face 'whole', 'right' has the cells of 'left'
  s:4     'left' says 6 cells
  s:5   spacing: the fractions of edge 'left', reversed
  s:5     'right' says: like edge 'left', against its direction
  s:4     'left' says: tanh law, first cell 0.01, last cell free
  s:10  imax of face 'whole': backwards, from 'a2' to 'b2'
  s:5   boundary 'wall' (BCWall)
)");
}

TEST_CASE("A count that follows from sums over sides tells the sum") {
    CHECK(explained(strip, "top") == R"(edge 'top'
  s:6   runs from vertex 'b0' [0, 1] to vertex 'b2' [2, 1]: a straight line, length 2
  s:6   7 cells: by sums over sides
  s:10    opposite sides of face 'whole' are equal: 'low1' (5) + 'low2' (2) = 'top' (7)
  s:6   spacing: uniform, as no edge parallel to it has a law
  s:10  jmax of face 'whole': forwards, from 'b0' to 'b2'
  s:6   boundary 'wall' (BCWall)
)");
}

TEST_CASE("An edge without a law tells the faces across which it took one") {
    const std::string row = R"(hexweave: 1
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 6, spacing: {law: geometric, ratio: 1.2}}
  low1: {from: a0, to: a1, cells: 5}
  low2: {from: a1, to: a2, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  wall: {type: BCWall, sides: [low1, low2, left, a2-b2, b0-b1, b1-b2]}
)";
    CHECK(explained(row, "b2-a2") == R"(edge 'a2-b2'
  s:9  runs from vertex 'a2' [2, 0] to vertex 'b2' [2, 1]: a straight line that nobody drew, made between two corners, length 1
  s:9  6 cells: as edge 'left'
  s:9    across face 'f2', 'a2-b2' has the cells of 'a1-b1'
  s:8    across face 'f1', 'a1-b1' has the cells of 'left'
  s:4    'left' says 6 cells
  s:9  spacing: the fractions of edge 'left'
  s:9    across face 'f2', 'a2-b2' has the spacing of 'a1-b1'
  s:8    across face 'f1', 'a1-b1' has the spacing of 'left'
  s:4    'left' says: geometric law, ratio 1.2
  s:9  imax of face 'f2': forwards, from 'a2' to 'b2'
  s:9  boundary 'wall' (BCWall)
)");
}

TEST_CASE("A name that nothing has is explained by nothing, and the names known are told") {
    CHECK(explained(strip, "no_such").empty());
    const auto source = std::make_shared<const SourceFile>(SourceFile{"s", strip});
    Diagnostics diagnostics;
    const Case written = read_case(source, {}, diagnostics);
    const std::vector<std::string> known = explained_names(resolve(written, diagnostics));
    CHECK(known == std::vector<std::string>{"a0", "a1", "a2", "b0", "b2", "left", "low1", "low2",
                                            "right", "top", "wall", "whole"});
}

TEST_CASE("A block tells which axes of a face run along its own") {
    const std::string box = R"(hexweave: 1
vertices: {a: [0, 0, 0], b: [1, 0, 0], c: [1, 1, 0], d: [0, 1, 0], e: [0, 0, 1], f: [1, 0, 1], g: [1, 1, 1], h: [0, 1, 1]}
edges:
  ab: {from: a, to: b, cells: 2}
  ad: {from: a, to: d, cells: 3}
  ae: {from: a, to: e, cells: 4}
faces:
  low: {corners: [a, d, c, b]}
blocks:
  box: {corners: [a, b, c, d, e, f, g, h]}
boundaries:
  wall: {type: BCWall, sides: [low, a-b-f-e, b-c-g-f, c-d-h-g, a-d-h-e, e-f-g-h]}
)";
    const std::string text = explained(box, "box");
    CHECK(text.find("  s:10  2 x 3 x 4 cells\n") != std::string::npos);
    CHECK(text.find("  s:10  corners: a, b, c, d, e, f, g, h\n") != std::string::npos);
    CHECK(text.find("  s:8   kmin: face 'low', i along its j, j along its i\n") !=
          std::string::npos);
}
