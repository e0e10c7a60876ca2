// SPDX-License-Identifier: Apache-2.0
// Resolving: what is said of boundaries.
#include <catch2/catch.hpp>

#include "topology/resolve_helpers.h"

using namespace hexweave;

TEST_CASE("The sides of a faulty face are not said to belong to none") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [2, 0], g: [2, 1]}
edges:
  ab: {from: a, to: b, cells: 2}
  bc: {from: b, to: c, cells: 2}
  cg: {from: c, to: g}
  be: {from: b, to: e, cells: 2, spacing: {like: ab}}  # keeps 'ab', whose face is at fault
  eg: {from: e, to: g}
  ad: {from: a, to: d}
faces:
  open: {imin: ad, imax: bc, jmin: ab, jmax: cg}
  sound: {imin: bc, imax: eg, jmin: be, jmax: cg}
boundaries:
  all: {type: BCWall, sides: [ab, ad, be, eg, cg]}
)";
    const std::string told = faults(text);
    CHECK(told.find("face 'open' is open") != std::string::npos);
    CHECK(told.find("no side of the grid") == std::string::npos);
}

TEST_CASE("A side that joins two faces is no boundary") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 9}
  mid: {from: a1, to: b1}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  wall: {type: BCWall, sides: [left, mid]}
)";
    CHECK(faults(text) == R"(12: error: edge 'mid' is no boundary: it joins faces 'f1' and 'f2'
  hint: take it out of boundary 'wall'
)");
}

TEST_CASE("A cut is no boundary") {
    const std::string text = R"(
curves:
  inner: {circle: {center: [0, 0], radius: 1}}
  outer: {circle: {center: [0, 0], radius: 2}}
vertices: {a: [1, 0], b: [2, 0]}
edges:
  in: {from: a, to: a, along: inner, cells: 16}
  out: {from: b, to: b, along: outer}
  seam: {from: a, to: b, cells: 8}
faces:
  ring: {imin: seam, imax: seam, jmin: -in, jmax: -out}
boundaries:
  all: {type: BCWall, sides: [in, out, seam]}
)";
    CHECK(faults(text) == R"(13: error: edge 'seam' is no boundary: it is a cut of face 'ring'
  hint: take it out of boundary 'all'
)");
}

TEST_CASE("A side is in one boundary") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 9}
  mid: {from: a1, to: b1}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  wall: {type: BCWall, sides: [left, bottom1, b1-b0]}
  far: {type: BCFarfield, sides: [bottom2, b1-b2, a2-b2, left]}
)";
    CHECK(faults(text) == R"(13: error: edge 'left' is named twice: boundary 'wall' has it already
  12: here
  hint: leave it in one of the two
)");
}

TEST_CASE("A boundary of a grid without blocks is made of edges") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 9}
  mid: {from: a1, to: b1}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  wall: {type: BCWall, sides: [f1]}
)";
    CHECK(faults(text) == R"(12: error: 'f1' is a face, but the sides of a boundary are edges
  hint: without blocks, boundaries are made of edges
)");
}

TEST_CASE("A boundary of a grid with blocks is made of faces") {
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
blocks:
  cube: {corners: [a, b, c, d, e, f, g, h]}
boundaries:
  wall: {type: BCWall, sides: [ab, bottom, top, west, east, south, north]}
)";
    CHECK(faults(text) == R"(25: error: 'ab' is an edge, but the sides of a boundary are faces
  hint: with blocks, boundaries are made of faces
)");
}

TEST_CASE("Free sides without a boundary are named in one warning") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 9}
  mid: {from: a1, to: b1}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  wall: {type: BCWall, sides: [left]}
)";
    CHECK(faults(text) ==
          R"(file: warning: no boundary names 'a2-b2', 'b0-b1', 'b1-b2', 'bottom1' and 'bottom2'
  hint: written as family 'unassigned', UserDefined; name them in 'boundaries'
)");
}

TEST_CASE("A side that no face has is no boundary") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 9}
  mid: {from: a1, to: b1}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
  lone: {from: a0, to: b2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  wall: {type: BCWall, sides: [lone, left, bottom1, b1-b0, bottom2, b1-b2, a2-b2]}
)";
    CHECK(faults(text) == R"(8: warning: edge 'lone' is not a side of any face
13: error: edge 'lone' is no side of the grid
  hint: no face has it; make it a side of a face, or take it out here
)");
}

TEST_CASE("A family does not take the name of a zone, nor that of the unassigned sides") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 9}
  mid: {from: a1, to: b1}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  f1: {type: BCWall, sides: [left, bottom1, b1-b0]}
  unassigned: {type: BCFarfield, sides: [bottom2, b1-b2, a2-b2]}
)";
    CHECK(faults(text) == R"(12: error: boundary 'f1' has the name of a face
  9: the other one
  hint: a CGNS file cannot hold a family and a zone of one name: rename one
13: error: 'unassigned' is the family of the sides that no boundary names
  hint: give this boundary another name
)");
}

TEST_CASE("A side off its symmetry plane is told how far") {
    const std::string text = R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 1e-6], b0: [0, 1], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 9}
  mid: {from: a1, to: b1}
  bottom1: {from: a0, to: a1, cells: 5}
  bottom2: {from: a1, to: a2, cells: 2}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  sym: {type: BCSymmetryPlane, plane: "y = 0", sides: [bottom1, bottom2]}
  far: {type: BCFarfield, sides: [left, b1-b0, b1-b2, a2-b2]}
)";
    CHECK(faults(text) == R"(12: error: edge 'bottom2' is 1e-06 off the symmetry plane y = 0
  hint: every point of the side must be on the plane, to 1e-9 of the size of the grid
)");
}

TEST_CASE("A symmetry plane moves its vertices exactly onto it and marks its edges and faces") {
    const std::string text = R"(
vertices: {a: [0, 0, 1e-12], b: [1, 0, 0], c: [1, 1, -1e-12], d: [0, 1, 0], e: [0, 0, 1], f: [1, 0, 1], g: [1, 1, 1], h: [0, 1, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  ad: {from: a, to: d, cells: 5}
  ae: {from: a, to: e, cells: 6}
blocks:
  cube: {corners: [a, b, c, d, e, f, g, h]}
boundaries:
  root: {type: BCSymmetryPlane, plane: "z = 0", sides: a-b-c-d}
  tip:  {type: BCSymmetryPlane, plane: "y = 1", sides: [c-d-h-g]}
  rest: {type: BCWall, sides: [e-f-g-h, a-b-f-e, b-c-g-f, a-d-h-e]}
)";
    CHECK(faults(text) == "");
    const Topology t = resolved(text);
    CHECK(named(t.vertices, "a").position == Vec3{0, 0, 0});
    CHECK(named(t.vertices, "c").position == Vec3{1, 1, 0});
    CHECK(named(t.edges, "ab").planes.size() == 1);
    CHECK(named(t.edges, "c-d").planes.size() == 2);
    CHECK(named(t.edges, "e-f").planes.empty());
    CHECK(evaluate(*named(t.edges, "ab").curve, 0) == Vec3{0, 0, 0});
    REQUIRE(named(t.faces, "a-b-c-d").plane);
    CHECK(named(t.faces, "a-b-c-d").plane->axis == 2);
    CHECK_FALSE(named(t.faces, "a-b-f-e").plane);
    CHECK(t.boundaries[1].plane->value == 1);
}
