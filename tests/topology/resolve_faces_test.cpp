// SPDX-License-Identifier: Apache-2.0
// Resolving: what is said of faces that do not close.
#include <catch2/catch.hpp>

#include "topology/resolve_helpers.h"

using namespace hexweave;

TEST_CASE("A left-handed face names the two sides to swap") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [2, 0], f: [2, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  bc: {from: b, to: c, cells: 4}
  dc: {from: d, to: c}
  ad: {from: a, to: d}
  be: {from: b, to: e, cells: 3}
  ef: {from: e, to: f}
  fc: {from: f, to: c}
faces:
  f: {imin: bc, imax: ad, jmin: ab, jmax: dc}
)";
    CHECK(faults(text) == R"(file: warning: no boundary names 'ab', 'ad', 'bc' and 'dc'
  hint: written as family 'unassigned', UserDefined; name them in 'boundaries'
8: warning: edge 'be' is not a side of any face
9: warning: edge 'ef' is not a side of any face
10: warning: edge 'fc' is not a side of any face
12: error: face 'f' is left-handed: seen from +z, i to j turns clockwise
  hint: swap its sides imin ('bc') and imax ('ad'), with what is asked of them
)");
}

TEST_CASE("An open face names the edges and vertices that do not meet") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [2, 0], f: [2, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  bc: {from: b, to: c, cells: 4}
  dc: {from: d, to: c}
  ad: {from: a, to: d}
  be: {from: b, to: e, cells: 3}
  ef: {from: e, to: f}
  fc: {from: f, to: c}
faces:
  f: {imin: ad, imax: ef, jmin: ab, jmax: dc}
)";
    CHECK(faults(text) == R"(5: warning: edge 'bc' is not a side of any face
8: warning: edge 'be' is not a side of any face
10: warning: edge 'fc' is not a side of any face
12: error: face 'f' is open: 'ef' (imax) starts at 'e', but 'ab' (jmin) ends at 'b'
  12: also: 'ef' (imax) ends at 'f', but 'dc' (jmax) ends at 'c'
  9: 'ef' runs from 'e' to 'f'
  4: 'ab' runs from 'a' to 'b'
  hint: imin and imax lead from jmin to jmax; jmin and jmax lead from imin to imax
)");
}

TEST_CASE("A broken side names the vertices that do not meet") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [2, 0], f: [2, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  bc: {from: b, to: c, cells: 4}
  dc: {from: d, to: c}
  ad: {from: a, to: d}
  be: {from: b, to: e, cells: 3}
  ef: {from: e, to: f}
  fc: {from: f, to: c}
faces:
  f: {imin: ad, imax: ef, jmin: [ab, ef], jmax: [dc, fc]}
)";
    CHECK(faults(text) == R"(5: warning: edge 'bc' is not a side of any face
8: warning: edge 'be' is not a side of any face
12: error: jmin of face 'f' is broken: 'ab' ends at 'b', but 'ef' starts at 'e'
  4: 'ab' runs from 'a' to 'b'
  9: 'ef' runs from 'e' to 'f'
  hint: list the edges of a side in the order of increasing i
)");
}

TEST_CASE("A side listed against its direction leaves the face open") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [2, 0], f: [2, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  bc: {from: b, to: c, cells: 4}
  dc: {from: d, to: c}
  ad: {from: a, to: d}
  be: {from: b, to: e, cells: 3}
  ef: {from: e, to: f}
  fc: {from: f, to: c}
faces:
  f: {imin: ad, imax: ef, jmin: [be, ab], jmax: [dc, fc]}
)";
    CHECK(faults(text) == R"(5: warning: edge 'bc' is not a side of any face
12: error: face 'f' is open: 'ad' (imin) starts at 'a', but 'be' (jmin) starts at 'e'
  12: also: 'ef' (imax) starts at 'e', but 'ab' (jmin) ends at 'a'
  7: 'ad' runs from 'a' to 'd'
  8: 'be' runs from 'b' to 'e'; here it is run through backwards
  hint: imin and imax lead from jmin to jmax; jmin and jmax lead from imin to imax
)");
}

TEST_CASE("A sign that contradicts the vertices leaves the face open") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [2, 0], f: [2, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  bc: {from: b, to: c, cells: 4}
  dc: {from: d, to: c}
  ad: {from: a, to: d}
  be: {from: b, to: e, cells: 3}
  ef: {from: e, to: f}
  fc: {from: f, to: c}
faces:
  f: {imin: ad, imax: bc, jmin: -ab, jmax: dc}
)";
    CHECK(faults(text) == R"(8: warning: edge 'be' is not a side of any face
9: warning: edge 'ef' is not a side of any face
10: warning: edge 'fc' is not a side of any face
12: error: face 'f' is open: 'ad' (imin) starts at 'a', but 'ab' (jmin) starts at 'b'
  12: also: 'bc' (imax) starts at 'b', but 'ab' (jmin) ends at 'a'
  7: 'ad' runs from 'a' to 'd'
  4: 'ab' runs from 'a' to 'b'; here it is run through backwards
  hint: imin and imax lead from jmin to jmax; jmin and jmax lead from imin to imax
)");
}

TEST_CASE("A left-handed face of corners is told the other order") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [2, 0], f: [2, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  bc: {from: b, to: c, cells: 4}
  dc: {from: d, to: c}
  ad: {from: a, to: d}
  be: {from: b, to: e, cells: 3}
  ef: {from: e, to: f}
  fc: {from: f, to: c}
faces:
  f: {corners: [b, c, f, e]}
)";
    CHECK(faults(text) == R"(file: warning: no boundary names 'bc', 'be', 'ef' and 'fc'
  hint: written as family 'unassigned', UserDefined; name them in 'boundaries'
4: warning: edge 'ab' is not a side of any face
6: warning: edge 'dc' is not a side of any face
7: warning: edge 'ad' is not a side of any face
12: error: face 'f' is left-handed: seen from +z, i to j turns clockwise
  hint: list its corners counter-clockwise: [b, e, f, c]
)");
}

TEST_CASE("A corner is named once") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [2, 0], f: [2, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  bc: {from: b, to: c, cells: 4}
  dc: {from: d, to: c}
  ad: {from: a, to: d}
  be: {from: b, to: e, cells: 3}
  ef: {from: e, to: f}
  fc: {from: f, to: c}
faces:
  f: {corners: [a, b, b, d]}
)";
    CHECK(faults(text) == R"(12: error: face 'f' names the corner 'b' twice
  hint: to collapse an edge to a vertex draw a pole, '{at: b}', and give the face by its four sides
)");
}

TEST_CASE("Closed edges in space leave directions ambiguous, and signs decide") {
    const std::string text = R"(
curves:
  inner: {circle: {center: [0, 0], radius: 1}}
  outer: {circle: {center: [0, 0, 1], normal: [0, 0, 1], radius: 2}}
vertices: {a: [1, 0], b: [2, 0, 1]}
edges:
  in: {from: a, to: a, along: inner, cells: 16}
  out: {from: b, to: b, along: outer}
  seam: {from: a, to: b, cells: 8}
faces:
  ring: {imin: seam, imax: seam, jmin: in, jmax: out}
boundaries:
  all: {type: BCWall, sides: [in, out]}
)";
    CHECK(faults(text) ==
          R"(11: error: the directions of 'in' and 'out' in face 'ring' are ambiguous
  hint: say it with a sign; these close: 'jmin: +in, jmax: +out' or 'jmin: +in, jmax: -out' or 'jmin: -in, jmax: +out' or 'jmin: -in, jmax: -out'
)");
}

TEST_CASE("One sign may leave another edge open") {
    const std::string text = R"(
curves:
  inner: {circle: {center: [0, 0], radius: 1}}
  outer: {circle: {center: [0, 0, 1], normal: [0, 0, 1], radius: 2}}
vertices: {a: [1, 0], b: [2, 0, 1]}
edges:
  in: {from: a, to: a, along: inner, cells: 16}
  out: {from: b, to: b, along: outer}
  seam: {from: a, to: b, cells: 8}
faces:
  ring: {imin: seam, imax: seam, jmin: in, jmax: -out}
boundaries:
  all: {type: BCWall, sides: [in, out]}
)";
    CHECK(faults(text) == R"(11: error: the direction of 'in' in face 'ring' is ambiguous
  hint: say it with a sign; these close: 'jmin: +in' or 'jmin: -in'
)");
}

namespace {

std::string planar_ring(const std::string& sides) {
    return R"(
curves:
  inner: {circle: {center: [0, 0], radius: 1}}
  outer: {circle: {center: [0, 0], radius: 2}}
vertices: {a: [1, 0], b: [2, 0]}
edges:
  in: {from: a, to: a, along: inner, cells: 16}
  out: {from: b, to: b, along: outer}
  seam: {from: a, to: b, cells: 8}
faces:
  ring: {imin: seam, imax: seam, )" +
           sides + R"(}
boundaries:
  all: {type: BCWall, sides: [in, out]}
)";
}

}  // namespace

TEST_CASE("In the plane the way round closed edges follows from that round the others") {
    for (const char* written :
         {"jmin: in, jmax: out", "jmin: in, jmax: -out", "jmin: -in, jmax: out",
          "jmin: -in, jmax: -out", "jmin: out, jmax: in"}) {
        INFO(written);
        CHECK(faults(planar_ring(written)).empty());
    }
    CHECK(
        faults(planar_ring("jmin: +in, jmax: -out")) ==
        R"(11: error: the sides of face 'ring' cross, or run round it in opposite senses: no grid can lie between them
  hint: run the other way round there: jmin: -in
)");
}

TEST_CASE("Sides that cross are told with a way that does not") {
    const std::string text = R"(
curves:
  over: {formula: [t, 0.1 * sin(pi * t)], range: [0, 1]}
  under: {formula: [t, -0.1 * sin(pi * t)], range: [0, 1]}
  bow: {arc: {center: [1, 0], radius: 3, from: pi/2, to: 3*pi/2}}
vertices: {nose: [0, 0], tail: [1, 0], out: [4, 0], high: [4, 3], low: [4, -3], front_high: [1, 3], front_low: [1, -3]}
edges:
  over: {from: nose, to: tail, along: over, cells: 16}
  under: {from: nose, to: tail, along: under, cells: 16}
  wake: {from: tail, to: out, cells: 8}
  top: {from: front_high, to: high, cells: 8}
  bottom: {from: front_low, to: low, cells: 8}
  bow: {from: front_low, to: front_high, along: bow}
  up: {from: out, to: high, cells: 8}
  down: {from: out, to: low}
faces:
  c: {jmin: [wake, over, under, wake], jmax: [bottom, bow, top], imin: down, imax: up}
boundaries:
  all: {type: BCWall, sides: [bottom, bow, down, over, top, under, up]}
)";
    CHECK(
        faults(text) ==
        R"(17: error: the sides of face 'c' cross, or run round it in opposite senses: no grid can lie between them
  hint: run the other way round there: jmin: [wake, under, over, wake]
)");
    const std::string bow_tie = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  bd: {from: b, to: d, cells: 4}
faces:
  f: {corners: [a, b, d, c]}
boundaries:
  all: {type: BCWall, sides: [a-c, ab, bd, c-d]}
)";
    CHECK(
        faults(bow_tie) ==
        R"(7: error: edges 'bd' and 'a-c' of face 'f' cross at [0.5, 0.5]: no grid can lie between its sides
  5: 'bd' is drawn here
  hint: list its corners going round it: [a, b, c, d]
)");
}

TEST_CASE("A left-handed ring runs the other way round, its cut as it is") {
    CHECK(faults(planar_ring("jmin: +in, jmax: +out")) ==
          R"(11: error: face 'ring' is left-handed: seen from +z, i to j turns clockwise
  hint: run i the other way round: jmin: -in, jmax: -out
)");
}

TEST_CASE("A cut is not on adjacent sides") {
    const std::string text = R"(
curves:
  circle: {circle: {center: [0, 0], radius: 1}}
vertices: {a: [1, 0]}
edges:
  x: {from: a, to: a, along: circle, cells: 8}
  z: {from: a, to: a, along: circle}
faces:
  f: {imin: +x, imax: +z, jmin: +x, jmax: +z}
)";
    CHECK(faults(text) == R"(9: error: edge 'x' is on the adjacent sides imin and jmin of face 'f'
  hint: a cut is on opposite sides, or twice on one side
9: error: edge 'z' is on the adjacent sides imax and jmax of face 'f'
  hint: a cut is on opposite sides, or twice on one side
)");
}

TEST_CASE("A face uses an edge twice at most") {
    const std::string text = R"(
curves:
  circle: {circle: {center: [0, 0], radius: 1}}
vertices: {a: [1, 0]}
edges:
  x: {from: a, to: a, along: circle, cells: 8}
  z: {from: a, to: a, along: circle}
faces:
  f: {imin: +x, imax: [+x, +x], jmin: +z, jmax: +z}
)";
    CHECK(faults(text) == R"(9: error: face 'f' uses edge 'x' more than twice
  hint: an edge is once on a side, or twice as a cut
)");
}

TEST_CASE("Several edges between two corners are a choice") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  ad: {from: a, to: d, cells: 5}
  ab2: {from: b, to: a, along: arc}
curves:
  arc: {polyline: [[0, 0], [0.5, -0.5], [1, 0]]}
faces:
  f: {corners: [a, b, c, d]}
  g: {corners: [b, a, d, c]}
)";
    CHECK(
        faults(text) ==
        R"(10: error: the corners 'a' and 'b' of face 'f' have several edges between them: 'ab' and 'ab2'
  hint: give the face by its four sides: imin: ad, imax: an edge drawn from b to c, jmin: ab or ab2, jmax: an edge drawn from d to c
)");
}

TEST_CASE("Sides on top of each other enclose no area") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [2, 0], d: [3, 0]}
edges:
  ab: {from: a, to: b, cells: 4}
  ad: {from: a, to: d, cells: 5}
faces:
  f: {corners: [a, b, c, d]}
boundaries:
  all: {type: BCWall, sides: [ab, ad, b-c, c-d]}
)";
    CHECK(faults(text) == R"(7: error: face 'f' encloses no area
  hint: its sides lie on top of each other: name others
)");
}

TEST_CASE("Three faces do not share an edge without blocks") {
    const std::string text = R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [2, 0], f: [2, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  bc: {from: b, to: c, cells: 4}
  dc: {from: d, to: c}
  ad: {from: a, to: d}
  be: {from: b, to: e, cells: 3}
  ef: {from: e, to: f}
  fc: {from: f, to: c}
faces:
  f: {imin: ad, imax: bc, jmin: ab, jmax: dc}
  g: {imin: bc, imax: ef, jmin: be, jmax: -fc}
  h: {corners: [b, a, d, c]}
)";
    CHECK(faults(text) == R"(file: warning: no boundary names 'be', 'ef' and 'fc'
  hint: written as family 'unassigned', UserDefined; name them in 'boundaries'
5: error: edge 'bc' is used 3 times, by faces 'f', 'g' and 'h'
  hint: at most two faces share one edge
14: error: face 'h' is left-handed: seen from +z, i to j turns clockwise
  hint: list its corners counter-clockwise: [b, c, d, a]
)");
}

TEST_CASE("The sides that a face asks to be orthogonal are marked, however the face is given") {
    const Topology t = resolved(R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [2, 0], f: [2, 1], g: [3, 0], h: [3, 1]}
edges: {ab: {from: a, to: b, cells: 4}, bc: {from: b, to: c, cells: 4}, dc: {from: d, to: c},
        ad: {from: a, to: d}, be: {from: b, to: e, cells: 3}, eg: {from: e, to: g, cells: 5}}
faces:
  sides: {imin: ad, imax: bc, jmin: ab, jmax: dc, orthogonal: [jmin, imax]}
  corners: {corners: [b, e, f, c], orthogonal: all}
  neither: {corners: [e, g, h, f]}
)");
    REQUIRE(t.faces.size() == 3);
    CHECK(t.faces[0].orthogonal == std::array{false, true, true, false});
    CHECK(t.faces[1].orthogonal == std::array{true, true, true, true});
    CHECK(t.faces[2].orthogonal == std::array{false, false, false, false});
}
