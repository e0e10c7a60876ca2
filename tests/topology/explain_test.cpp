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
  s:7     'low1' says 5 cells
  s:8     'low2' says 2 cells
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

TEST_CASE("A count that comes through a sum tells the way to it, and where its parts come from") {
    const std::string text = R"(hexweave: 1
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b2: [2, 1], c0: [0, 2], c2: [2, 2], d0: [0, -1], d1: [1, -1]}
edges:
  left: {from: a0, to: b0, cells: 6}
  low1: {from: a0, to: a1}
  low2: {from: a1, to: a2, cells: 2}
  middle: {from: b0, to: b2}
  right: {from: a2, to: b2}
  up: {from: b0, to: c0, cells: 3}
  bottom: {from: d0, to: d1, cells: 5}
  deep: {from: d0, to: a0, cells: 4}
faces:
  low: {imin: left, imax: right, jmin: [low1, low2], jmax: middle}
  high: {corners: [b0, b2, c2, c0]}
  under: {corners: [d0, d1, a1, a0]}
boundaries:
  wall: {type: BCWall, sides: [left, right, low2, bottom, deep, d1-a1, c0-c2, up, b2-c2]}
)";
    CHECK(explained(text, "c0-c2") == R"(edge 'c0-c2'
  s:14  runs from vertex 'c0' [0, 2] to vertex 'c2' [2, 2]: a straight line that nobody drew, made between two corners, length 2
  s:14  7 cells: by sums over sides
  s:14    across face 'high', 'c0-c2' has the cells of 'middle'
  s:13    opposite sides of face 'low' are equal: 'low1' (5) + 'low2' (2) = 'middle' (7)
  s:15    across face 'under', 'low1' has the cells of 'bottom'
  s:10    'bottom' says 5 cells
  s:6     'low2' says 2 cells
  s:14  spacing: uniform, as no edge parallel to it has a law
  s:14  jmax of face 'high': forwards, from 'c0' to 'c2'
  s:14  boundary 'wall' (BCWall)
)");
    CHECK(explained(text, "low") == R"(face 'low'
  s:13  7 x 6 cells
  s:13  corners: a0, a2, b2, b0
  s:4   imin: edge 'left' forwards, from 'a0' to 'b0', 6 cells
  s:8   imax: edge 'right' forwards, from 'a2' to 'b2', 6 cells
  s:5   jmin: edge 'low1' forwards, from 'a0' to 'a1', 5 cells
  s:6   jmin: edge 'low2' forwards, from 'a1' to 'a2', 2 cells
  s:7   jmax: edge 'middle' forwards, from 'b0' to 'b2', 7 cells
  s:13  7 cells along i: 'middle'
  s:13    opposite sides of face 'low' are equal: 'low1' (5) + 'low2' (2) = 'middle' (7)
  s:15    across face 'under', 'low1' has the cells of 'bottom'
  s:10    'bottom' says 5 cells
  s:6     'low2' says 2 cells
  s:13  6 cells along j: 'left'
  s:4     'left' says 6 cells
)");
}

TEST_CASE("What stands in a component tells its instance, and ports and instances are explained") {
    const std::string text = R"(hexweave: 1
components:
  strip:
    parameters: {length: 1, cells: required}
    ports: {left: west, right: east}
    vertices: {a: [0, 0], b: [length, 0], c: [length, 1], d: [0, 1]}
    edges:
      south: {from: a, to: b, cells: cells}
      west: {from: a, to: d, cells: 8}
      east: {from: c, to: b}
    faces: {field: {corners: [a, b, c, d]}}
    boundaries: {floor: {type: BCWall, sides: south}}
instances:
  main: {of: strip, set: {cells: 20}}
  tail: {of: strip, set: {cells: 10}, translate: [1, 0], join: {left: main.right}}
)";
    CHECK(explained(text, "tail.west") == R"(edge 'tail.west' is edge 'main.east', backwards
  s:15  joined here
edge 'main.east'
  s:10  runs from vertex 'main.c' [1, 1] to vertex 'main.b' [1, 0]: a straight line, length 1
  s:14  in instance 'main', written here
  s:9   8 cells: said here
  s:10  spacing: uniform, as no edge parallel to it has a law
  s:11  imax of face 'main.field': backwards, from 'main.b' to 'main.c'
  s:11  imin of face 'tail.field': backwards, from 'main.b' to 'main.c'
)");
    CHECK(explained(text, "tail") == R"(instance 'tail'
  s:15  uses component 'strip'
  s:3   the component
  s:4   length = 1
  s:4   cells = 10
  s:15  vertex 'tail.a' is vertex 'main.b'
  s:15  vertex 'tail.d' is vertex 'main.c'
  s:15  edge 'tail.west' is edge 'main.east', backwards
)");
}

TEST_CASE("A name that nothing has is explained by nothing, and the names known are told") {
    CHECK(explained(strip, "no_such").empty());
    const auto source = std::make_shared<const SourceFile>(SourceFile{"s", strip});
    Diagnostics diagnostics;
    const Case written = read_case(source, {}, diagnostics);
    const std::vector<std::string> known = explained_names(written, resolve(written, diagnostics));
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
