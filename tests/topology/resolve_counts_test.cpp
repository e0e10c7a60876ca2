// SPDX-License-Identifier: Apache-2.0
// Resolving: what is said of cell counts.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <string>

#include "topology/resolve_helpers.h"

using namespace hexweave;

TEST_CASE("Counts in conflict are told by the chain of faces between") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], a3: [3, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1], b3: [3, 1]}
edges:
  left: {from: a0, to: b0, cells: 64}
  mid: {from: a1, to: b1}
  down: {from: b2, to: a2}
  right: {from: a3, to: b3, cells: 48}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
  bottom3: {from: a2, to: a3, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
  f3: {corners: [a2, a3, b3, b2]}
boundaries:
  all: {type: BCWall, sides: [left, right, bottom1, bottom2, bottom3, b0-b1, b1-b2, b2-b3]}
)";
    CHECK(faults(text) ==
          R"(7: error: edge 'right' has 48 cells, but edge 'left', parallel to it, has 64 cells
  14: across face 'f3', 'down' has as many cells as 'right'
  13: across face 'f2', 'mid' has as many cells as 'down'
  12: across face 'f1', 'left' has as many cells as 'mid'
  4: 'left' has 64 cells
  hint: parallel edges have equally many cells: give 'cells' to one of them
)");
}

TEST_CASE("What most edges of a chain say prevails, and each other one is reported") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], a3: [3, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1], b3: [3, 1]}
edges:
  left: {from: a0, to: b0, cells: 64}
  mid: {from: a1, to: b1, cells: 64}
  down: {from: b2, to: a2, cells: 32}
  right: {from: a3, to: b3, cells: 48}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
  bottom3: {from: a2, to: a3, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
  f3: {corners: [a2, a3, b3, b2]}
boundaries:
  all: {type: BCWall, sides: [left, right, bottom1, bottom2, bottom3, b0-b1, b1-b2, b2-b3]}
)";
    CHECK(faults(text) ==
          R"(6: error: edge 'down' has 32 cells, but edge 'mid', parallel to it, has 64 cells
  13: across face 'f2', 'mid' has as many cells as 'down'
  5: 'mid' has 64 cells
  hint: parallel edges have equally many cells: give 'cells' to one of them
7: error: edge 'right' has 48 cells, but edge 'mid', parallel to it, has 64 cells
  14: across face 'f3', 'down' has as many cells as 'right'
  13: across face 'f2', 'mid' has as many cells as 'down'
  5: 'mid' has 64 cells
  hint: parallel edges have equally many cells: give 'cells' to one of them
)");
}

TEST_CASE("A chain without a count lists its edges") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], a3: [3, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1], b3: [3, 1]}
edges:
  left: {from: a0, to: b0, spacing: uniform}
  mid: {from: a1, to: b1}
  down: {from: b2, to: a2}
  right: {from: a3, to: b3, spacing: uniform}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
  bottom3: {from: a2, to: a3, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
  f3: {corners: [a2, a3, b3, b2]}
boundaries:
  all: {type: BCWall, sides: [left, right, bottom1, bottom2, bottom3, b0-b1, b1-b2, b2-b3]}
)";
    CHECK(faults(text) ==
          R"(4: error: nothing says how many cells edges 'left', 'mid', 'down' and 'right' have
  hint: they are parallel: give one of them 'cells', as in 'cells: 40'
)");
}

TEST_CASE("A sum over a side gives what one edge lacks") {
    const std::string text = R"(
vertices: {a: [0, 0], m: [1, 0], b: [2, 0], c: [2, 1], d: [0, 1]}
edges:
  am: {from: a, to: m, cells: 10}
  mb: {from: m, to: b}
  bc: {from: b, to: c, cells: 3}
  dc: {from: d, to: c, cells: 17}
  da: {from: d, to: a}
faces:
  f: {imin: da, imax: bc, jmin: [am, mb], jmax: dc}
boundaries:
  all: {type: BCWall, sides: [am, mb, bc, dc, da]}
)";
    CHECK(faults(text) == "");
}

TEST_CASE("Sums that differ tell where each count comes from") {
    const std::string text = R"(
vertices: {a: [0, 0], m: [1, 0], b: [2, 0], c: [2, 1], d: [0, 1]}
edges:
  am: {from: a, to: m, cells: 10}
  mb: {from: m, to: b, cells: 6}
  bc: {from: b, to: c, cells: 3}
  dc: {from: d, to: c, cells: 17}
  da: {from: d, to: a}
faces:
  f: {imin: da, imax: bc, jmin: [am, mb], jmax: dc}
boundaries:
  all: {type: BCWall, sides: [am, mb, bc, dc, da]}
)";
    CHECK(faults(text) == R"(10: error: jmin of face 'f' has 16 cells, but jmax has 17 cells
  4: 'am' has 10 cells
  5: 'mb' has 6 cells
  7: 'dc' has 17 cells
  hint: opposite sides have equally many cells in all
)");
}

TEST_CASE("A sum that leaves nothing for an edge is refused") {
    const std::string text = R"(
vertices: {a: [0, 0], m: [1, 0], b: [2, 0], c: [2, 1], d: [0, 1]}
edges:
  am: {from: a, to: m, cells: 10}
  mb: {from: m, to: b}
  bc: {from: b, to: c, cells: 3}
  dc: {from: d, to: c, cells: 9}
  da: {from: d, to: a}
faces:
  f: {imin: da, imax: bc, jmin: [am, mb], jmax: dc}
boundaries:
  all: {type: BCWall, sides: [am, mb, bc, dc, da]}
)";
    CHECK(faults(text) ==
          R"(10: error: no number of cells of edge 'mb' makes jmin and jmax of face 'f' equal
  4: 'am' has 10 cells
  7: 'dc' has 9 cells
  hint: opposite sides have equally many cells in all
)");
}

TEST_CASE("Edges that a sum joins are listed together") {
    const std::string text = R"(
vertices: {a: [0, 0], m: [1, 0], b: [2, 0], c: [2, 1], d: [0, 1]}
edges:
  am: {from: a, to: m, cells: 10}
  mb: {from: m, to: b}
  bc: {from: b, to: c, cells: 3}
  dc: {from: d, to: c}
  da: {from: d, to: a}
faces:
  f: {imin: da, imax: bc, jmin: [am, mb], jmax: dc}
boundaries:
  all: {type: BCWall, sides: [am, mb, bc, dc, da]}
)";
    CHECK(faults(text) == R"(5: error: nothing says how many cells edges 'mb' and 'dc' have
  hint: sides of several edges join them: give 'cells' to more of them, until the others follow
)");
}

TEST_CASE("A list of points gives the count") {
    const std::string text = R"(
vertices: {a: [0, 0], m: [1, 0], b: [2, 0], c: [2, 1], d: [0, 1]}
edges:
  am: {from: a, to: m, cells: 10}
  mb: {from: m, to: b, cells: 6}
  bc: {from: b, to: c, spacing: {positions: [0, 0.1, 0.5, 1]}}
  dc: {from: d, to: c}
  da: {from: d, to: a}
faces:
  f: {imin: da, imax: bc, jmin: [am, mb], jmax: dc}
boundaries:
  all: {type: BCWall, sides: [am, mb, bc, dc, da]}
)";
    CHECK(faults(text) == "");
}

TEST_CASE("A list of points and another count are a conflict") {
    const std::string text = R"(
vertices: {a: [0, 0], m: [1, 0], b: [2, 0], c: [2, 1], d: [0, 1]}
edges:
  am: {from: a, to: m, cells: 10}
  mb: {from: m, to: b, cells: 6}
  bc: {from: b, to: c, cells: 4, spacing: {positions: [0, 0.1, 0.5, 1]}}
  dc: {from: d, to: c}
  da: {from: d, to: a}
faces:
  f: {imin: da, imax: bc, jmin: [am, mb], jmax: dc}
boundaries:
  all: {type: BCWall, sides: [am, mb, bc, dc, da]}
)";
    CHECK(faults(text) ==
          R"(6: error: edge 'bc' has 4 cells, but its spacing lists 4 points, for 3 cells
  6: the list is here
  hint: leave 'cells' out: the list says it
)");
}

TEST_CASE("A count that no zone can hold is refused") {
    // One edge has at most ten million cells; a side of many edges can have more than 2^31.
    constexpr int parts = 215;
    std::string vertices;
    std::string edges;
    std::string side;
    for (int i = 0; i < parts; ++i) {
        vertices += fmt::format("v{}: [{}, 0], ", i, i);
        edges += fmt::format("  p{}: {{from: v{}, to: v{}, cells: 10000000}}\n", i, i, i + 1);
        side += fmt::format("{}p{}", i == 0 ? "" : ", ", i);
    }
    const std::string text =
        "\nvertices: {" + vertices +
        fmt::format("v{}: [{}, 0], c: [{}, 1], d: [0, 1]}}\n", parts, parts, parts) + "edges:\n" +
        edges + fmt::format("  bc: {{from: v{}, to: c, cells: 3}}\n", parts) +
        "  dc: {from: d, to: c}\n  da: {from: d, to: v0}\nfaces:\n  f: {imin: da, imax: bc, jmin: "
        "[" +
        side + "], jmax: dc}\nboundaries:\n  all: {type: BCWall, sides: [" + side +
        ", bc, dc, da]}\n";
    CHECK(faults(text) ==
          R"(220: error: edge 'dc' has 2150000000 cells: more than a CGNS zone can hold
  hint: give its edges fewer cells
223: error: face 'f' has 2150000000 cells: more than a CGNS zone can hold
  hint: give its edges fewer cells
)");
}
