// SPDX-License-Identifier: Apache-2.0
// Resolving: what is said of names.
#include <catch2/catch.hpp>

#include "topology/names.h"
#include "topology/resolve_helpers.h"

using namespace hexweave;

TEST_CASE("An unknown name comes with the nearest one, or with what is known") {
    const std::string text = R"(
curves:
  upper: {circle: {center: [0, 0], radius: 1}}
vertices:
  a: [0, 0]
  b: [1, 0]
  c: [1, 1]
  d: [0, 1]
  e: {curve: uper, at: 0}
edges:
  bottom: {from: a, to: bb, cells: 4}
  right: {from: b, to: c, cells: 4}
  top: {from: d, to: c}
  left: {from: a, to: d, along: oval}
faces:
  square: {imin: lefft, imax: right, jmin: bottom, jmax: top}
blocks:
  cube: {imin: sqare, imax: square, jmin: square, jmax: square, kmin: square, kmax: square}
  box: {corners: [a, b, c, d, e, f, g, h]}
boundaries:
  wall: {type: BCWall, sides: [squares]}
)";
    CHECK(faults(text) == R"(9: error: unknown curve 'uper'
  hint: did you mean 'upper'?
11: error: unknown vertex 'bb'
  hint: known: 'a', 'b', 'c', 'd' and 'e'
14: error: unknown curve 'oval'
  hint: known: 'upper'
16: error: unknown edge 'lefft'
  hint: did you mean 'left'?
18: error: unknown face 'sqare'
  hint: did you mean 'square'?
19: error: unknown vertex 'f'
  hint: known: 'a', 'b', 'c', 'd' and 'e'
19: error: unknown vertex 'g'
  hint: known: 'a', 'b', 'c', 'd' and 'e'
19: error: unknown vertex 'h'
  hint: known: 'a', 'b', 'c', 'd' and 'e'
21: error: unknown face 'squares'
  hint: did you mean 'square'?
)");
}

TEST_CASE("What nothing uses is warned of") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], far: [9, 9]}
edges:
  ab: {from: a, to: b, cells: 4}
  ad: {from: a, to: d, cells: 5}
  diagonal: {from: a, to: c}
faces:
  f: {corners: [a, b, c, d]}
boundaries:
  all: {type: BCWall, sides: [ab, ad, b-c, c-d]}
curves:
  spare: {circle: {center: [0, 0], radius: 1}}
  used: {circle: {center: [0, 0], radius: 1}}
  moved: {of: used, translate: [1, 0]}
)";
    CHECK(faults(text) == R"(2: warning: vertex 'far' is not used
6: warning: edge 'diagonal' is not a side of any face
12: warning: curve 'spare' is not used
14: warning: curve 'moved' is not used
)");
}

TEST_CASE("What may be unused for another fault is not warned of") {
    // `wall` is what `roof` is a misspelling of; `rim` cannot be matched, as it misses its curve.
    const std::string text = R"(
curves:
  circle: {circle: {center: [0, 0], radius: 1}}
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [0, 2], f: [2, 0]}
edges:
  ab: {from: a, to: b, cells: 4}
  ad: {from: a, to: d, cells: 5}
  wall: {from: d, to: c}
  rim: {from: b, to: f, along: circle}
  up: {from: d, to: ee}
faces:
  square: {imin: ad, imax: b-c, jmin: ab, jmax: roof}
)";
    CHECK(faults(text) == R"(9: error: vertex 'f' is not on the curve 'circle': it is 1 away
  hint: the nearest point of the curve is {curve: circle, at: 0}, at [1, 0]
10: error: unknown vertex 'ee'
  hint: known: 'a', 'b', 'c', 'd', 'e' and 'f'
12: error: unknown edge 'b-c'
  hint: a name of corners is made only where a face or block given by its 'corners' needs it; else draw it under 'edges'
12: error: unknown edge 'roof'
  hint: known: 'ab', 'ad', 'rim', 'up' and 'wall'
)");
}

TEST_CASE("Two vertices that no edge joins are not taken for two others") {
    CHECK(faults(R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [2, 0], f: [2, 1]}
edges:
  left: {from: a, to: d, cells: 4}
  floor: {from: a, to: b, cells: 4}
  mid: {from: b, to: c}
faces:
  ch: {imin: left, imax: mid, jmin: floor, jmax: c-d}
  dn: {corners: [b, e, f, c]}
)") == R"(8: error: unknown edge 'c-d'
  hint: a name of corners is made only where a face or block given by its 'corners' needs it; else draw it under 'edges'
)");
}

TEST_CASE("With blocks, a face that no block has is warned of, and so is not its every edge") {
    const std::string text = R"(
vertices:
  a: [0, 0, 0]
  b: [1, 0, 0]
  c: [1, 1, 0]
  d: [0, 1, 0]
  e: [0, 0, 1]
  f: [1, 0, 1]
  g: [1, 1, 1]
  h: [0, 1, 1]
edges:
  ab: {from: a, to: b, cells: 4}
  ad: {from: a, to: d, cells: 5}
  ae: {from: a, to: e, cells: 6}
faces:
  bottom: {corners: [a, b, c, d]}
  top: {corners: [e, f, g, h]}
  west: {corners: [a, d, h, e]}
  east: {corners: [b, c, g, f]}
  south: {corners: [a, b, f, e]}
  north: {corners: [d, c, g, h]}
  diagonal: {corners: [a, b, g, h]}
blocks:
  cube: {corners: [a, b, c, d, e, f, g, h]}
boundaries:
  wall: {type: BCWall, sides: [bottom, top, west, east, south, north]}
)";
    CHECK(faults(text) == R"(22: warning: face 'diagonal' is not a side of any block
)");
}

TEST_CASE("A made edge has one name in any spelling, and a drawn one keeps its own") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  ad: {from: a, to: d, cells: 5}
faces:
  f: {corners: [a, b, c, d]}
boundaries:
  all: {type: BCWall, sides: [b-a, ad, c-b, d-c, d-b]}
)";
    CHECK(faults(text) == R"(9: error: unknown edge 'b-a'
  hint: the edge between these vertices is drawn as 'ab'
9: error: unknown edge 'd-b'
  hint: a name of corners is made only where a face or block given by its 'corners' needs it; else draw it under 'edges'
)");
}

TEST_CASE("An edge spelled by its ends is told by its drawn name") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  ad: {from: a, to: d, cells: 5}
faces:
  f: {corners: [a, b, c, d]}
  g: {imin: a-b, imax: ad, jmin: b-c, jmax: c-d}
boundaries:
  all: {type: BCWall, sides: [ab, ad, b-c, c-d]}
)";
    CHECK(faults(text) == R"(8: error: unknown edge 'a-b'
  hint: the edge between these vertices is drawn as 'ab'
)");
}

TEST_CASE("A block where a face is wanted is told to be one") {
    CHECK(first_error(R"(
vertices: {a: [0, 0, 0], b: [1, 0, 0], c: [1, 1, 0], d: [0, 1, 0], e: [0, 0, 1], f: [1, 0, 1], g: [1, 1, 1], h: [0, 1, 1]}
edges: {ab: {from: a, to: b, cells: 2}, ad: {from: a, to: d, cells: 2}, ae: {from: a, to: e, cells: 2}}
blocks: {middle: {corners: [a, b, c, d, e, f, g, h]}}
boundaries: {wall: {type: BCWall, sides: [middle]}}
)") == R"(5: error: unknown face 'middle'
  hint: 'middle' is a block; the name of a face is wanted here
)");
}

TEST_CASE("A file without faces and blocks describes no grid") {
    const std::string text = R"(
title: nothing
)";
    CHECK(faults(text) == R"(file: error: the file describes no grid
  hint: give it 'faces', or 'blocks'
)");
}

TEST_CASE("Made names are canonical: every spelling gives the same") {
    CHECK(made_edge_name("b", "a") == "a-b");
    CHECK(made_face_name({"c", "d", "a", "b"}) == "a-b-c-d");
    CHECK(made_face_name({"c", "b", "a", "d"}) == "a-b-c-d");
    CHECK(made_face_name({"a", "c", "b", "d"}) == "a-c-b-d");
    CHECK(canonical_name("b-d-c-a") == "a-b-d-c");
    CHECK(canonical_name("far_field") == "far_field");
}

TEST_CASE("A made name that CGNS cannot hold is cut and told apart by a hash") {
    const std::string name = made_edge_name("leading_edge_of_the_wing", "far_field_upstream_left");
    CHECK(name == "far_field_upstream_-6546af4b7860");
    CHECK(name.size() == 32);
    CHECK(name != made_edge_name("leading_edge_of_the_wing_", "far_field_upstream_left"));
    CHECK(canonical_name("leading_edge_of_the_wing-far_field_upstream_left") == name);
}
