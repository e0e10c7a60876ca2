// SPDX-License-Identifier: Apache-2.0
// Resolving: what is said of blocks that do not close.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "topology/face_frame.h"
#include "topology/resolve_helpers.h"

using namespace hexweave;

TEST_CASE("A left-handed block names the two sides to swap") {
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
  cube: {imin: west, imax: east, jmin: south, jmax: north, kmin: top, kmax: bottom}
boundaries:
  wall: {type: BCWall, sides: [bottom, top, west, east, south, north]}
)";
    CHECK(faults(text) == R"(23: error: block 'cube' is left-handed
  hint: swap its sides kmin ('top') and kmax ('bottom')
)");
}

TEST_CASE("A left-handed block of corners is told the other order") {
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
blocks:
  cube: {corners: [e, f, g, h, a, b, c, d]}
boundaries:
  all: {type: BCWall, sides: [a-b-c-d, h-g-f-e, a-b-f-e, b-c-g-f, c-d-h-g, a-d-h-e]}
)";
    CHECK(faults(text) == R"(16: error: block 'cube' is left-handed
  hint: four corners round one side, then those above them in the same order: [a, b, c, d, e, f, g, h]
)");
}

TEST_CASE("Faces that share no edge do not close a block") {
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
  cube: {imin: west, imax: south, jmin: east, jmax: north, kmin: bottom, kmax: top}
boundaries:
  wall: {type: BCWall, sides: [bottom, top, west, east, south, north]}
)";
    CHECK(faults(text) ==
          R"(23: error: block 'cube' does not close: 'west' (imin) and 'east' (jmin) share no edge
  23: nor do 'south' (imax) and 'north' (jmax)
  hint: faces on adjacent sides of a block have one side, edge for edge, in common
)");
}

TEST_CASE("A block has no cut around an edge") {
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
  cube: {imin: west, imax: south, jmin: south, jmax: north, kmin: bottom, kmax: top}
boundaries:
  wall: {type: BCWall, sides: [bottom, top, west, east, south, north]}
)";
    CHECK(faults(text) == R"(19: warning: face 'east' is not a side of any block
23: error: face 'south' is on the adjacent sides imax and jmin of block 'cube'
  hint: a cut is on opposite sides
)");
}

TEST_CASE("Axes that contradict the edges are refused") {
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
  cube: {imin: west, imax: east, jmin: south, jmax: north, kmin: {face: bottom, axes: [j, i]}, kmax: top}
boundaries:
  wall: {type: BCWall, sides: [bottom, top, west, east, south, north]}
)";
    CHECK(faults(text) ==
          R"(23: error: 'axes: [j, i]' of 'bottom' (kmin) contradict the edges of block 'cube'
  hint: the edges ask for 'axes: [i, j]'
)");
}

TEST_CASE("Axes that say what the edges say are no fault") {
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
  cube: {imin: west, imax: east, jmin: south, jmax: north, kmin: {face: bottom, axes: [i, j]}, kmax: top}
boundaries:
  wall: {type: BCWall, sides: [bottom, top, west, east, south, north]}
)";
    CHECK(faults(text) == "");
}

TEST_CASE("An O-type block is ambiguous until axes are given") {
    const std::string text = R"(
curves:
  inner: {circle: {center: [0, 0], radius: 1}}
  outer: {circle: {center: [0, 0], radius: 2}}
  inner1: {of: inner, translate: [0, 0, 1]}
  outer1: {of: outer, translate: [0, 0, 1]}
vertices: {a: [1, 0], b: [2, 0], a1: [1, 0, 1], b1: [2, 0, 1]}
edges:
  in: {from: a, to: a, along: inner, cells: 16}
  out: {from: b, to: b, along: outer}
  seam: {from: a, to: b, cells: 8}
  in1: {from: a1, to: a1, along: inner1}
  out1: {from: b1, to: b1, along: outer1}
  seam1: {from: a1, to: b1}
  aa: {from: a, to: a1, cells: 3}
  bb: {from: b, to: b1}
faces:
  ring: {imin: seam, imax: seam, jmin: +in, jmax: +out}
  ring1: {imin: seam1, imax: seam1, jmin: +in1, jmax: +out1}
  cut: {imin: aa, imax: bb, jmin: seam, jmax: seam1}
  tube: {imin: aa, imax: aa, jmin: +in, jmax: +in1}
  shell: {imin: bb, imax: bb, jmin: +out, jmax: +out1}
blocks:
  o: {imin: cut, imax: cut, jmin: tube, jmax: shell, kmin: ring, kmax: ring1}
boundaries:
  all: {type: BCWall, sides: [tube, shell, ring, ring1]}
)";
    CHECK(faults(text) == R"(24: error: the orientation of the faces of block 'o' is ambiguous
  hint: say it by the axes of a face: 'jmin: {face: tube, axes: [-i, j]}' or 'jmin: {face: tube, axes: [i, j]}' (left-handed)
)");
}

TEST_CASE("An O-type block with axes against its hand is left-handed") {
    const std::string text = R"(
curves:
  inner: {circle: {center: [0, 0], radius: 1}}
  outer: {circle: {center: [0, 0], radius: 2}}
  inner1: {of: inner, translate: [0, 0, 1]}
  outer1: {of: outer, translate: [0, 0, 1]}
vertices: {a: [1, 0], b: [2, 0], a1: [1, 0, 1], b1: [2, 0, 1]}
edges:
  in: {from: a, to: a, along: inner, cells: 16}
  out: {from: b, to: b, along: outer}
  seam: {from: a, to: b, cells: 8}
  in1: {from: a1, to: a1, along: inner1}
  out1: {from: b1, to: b1, along: outer1}
  seam1: {from: a1, to: b1}
  aa: {from: a, to: a1, cells: 3}
  bb: {from: b, to: b1}
faces:
  ring: {imin: seam, imax: seam, jmin: +in, jmax: +out}
  ring1: {imin: seam1, imax: seam1, jmin: +in1, jmax: +out1}
  cut: {imin: aa, imax: bb, jmin: seam, jmax: seam1}
  tube: {imin: aa, imax: aa, jmin: +in, jmax: +in1}
  shell: {imin: bb, imax: bb, jmin: +out, jmax: +out1}
blocks:
  o: {imin: cut, imax: cut, jmin: {face: tube, axes: [i, j]}, jmax: shell, kmin: ring, kmax: ring1}
boundaries:
  all: {type: BCWall, sides: [tube, shell, ring, ring1]}
)";
    CHECK(faults(text) == R"(24: error: block 'o' is left-handed
  hint: swap its sides kmin ('ring') and kmax ('ring1')
)");
}

TEST_CASE("An O-type block with axes resolves") {
    const std::string text = R"(
curves:
  inner: {circle: {center: [0, 0], radius: 1}}
  outer: {circle: {center: [0, 0], radius: 2}}
  inner1: {of: inner, translate: [0, 0, 1]}
  outer1: {of: outer, translate: [0, 0, 1]}
vertices: {a: [1, 0], b: [2, 0], a1: [1, 0, 1], b1: [2, 0, 1]}
edges:
  in: {from: a, to: a, along: inner, cells: 16}
  out: {from: b, to: b, along: outer}
  seam: {from: a, to: b, cells: 8}
  in1: {from: a1, to: a1, along: inner1}
  out1: {from: b1, to: b1, along: outer1}
  seam1: {from: a1, to: b1}
  aa: {from: a, to: a1, cells: 3}
  bb: {from: b, to: b1}
faces:
  ring: {imin: seam, imax: seam, jmin: +in, jmax: +out}
  ring1: {imin: seam1, imax: seam1, jmin: +in1, jmax: +out1}
  cut: {imin: aa, imax: bb, jmin: seam, jmax: seam1}
  tube: {imin: aa, imax: aa, jmin: +in, jmax: +in1}
  shell: {imin: bb, imax: bb, jmin: +out, jmax: +out1}
blocks:
  o: {imin: cut, imax: cut, jmin: {face: tube, axes: [-i, j]}, jmax: shell, kmin: ring, kmax: ring1}
boundaries:
  all: {type: BCWall, sides: [tube, shell, ring, ring1]}
)";
    CHECK(faults(text) == "");
}

TEST_CASE("Faces that share edges in pairs may still not close") {
    const std::string text = R"(
curves:
  inner: {circle: {center: [0, 0], radius: 1}}
  outer: {circle: {center: [0, 0], radius: 2}}
  inner1: {of: inner, translate: [0, 0, 1]}
  outer1: {of: outer, translate: [0, 0, 1]}
vertices: {a: [1, 0], b: [2, 0], a1: [1, 0, 1], b1: [2, 0, 1]}
edges:
  in: {from: a, to: a, along: inner, cells: 16}
  out: {from: b, to: b, along: outer}
  seam: {from: a, to: b, cells: 8}
  in1: {from: a1, to: a1, along: inner1}
  out1: {from: b1, to: b1, along: outer1}
  seam1: {from: a1, to: b1}
  aa: {from: a, to: a1, cells: 3}
  bb: {from: b, to: b1}
faces:
  ring: {imin: seam, imax: seam, jmin: +in, jmax: +out}
  ring1: {imin: seam1, imax: seam1, jmin: +in1, jmax: -out1}
  cut: {imin: aa, imax: bb, jmin: seam, jmax: seam1}
  tube: {imin: aa, imax: aa, jmin: +in, jmax: +in1}
  shell: {imin: bb, imax: bb, jmin: +out, jmax: +out1}
blocks:
  o: {imin: cut, imax: cut, jmin: tube, jmax: shell, kmin: ring, kmax: ring1}
boundaries:
  all: {type: BCWall, sides: [tube, shell, ring, ring1]}
)";
    CHECK(
        faults(text) ==
        R"(24: error: block 'o' does not close: each two adjacent faces share an edge, but all six do not fit together
  hint: check which face is on which side
)");
}

TEST_CASE("A made face that was drawn is told by its drawn name") {
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
  wall: {type: BCWall, sides: [d-c-b-a, top, west, east, south, north]}
)";
    CHECK(faults(text) == R"(25: error: unknown face 'd-c-b-a'
  hint: the face between these vertices is drawn as 'bottom'
)");
}

TEST_CASE("Several faces between the corners of a block are a choice") {
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
  one: {corners: [a, b, c, d]}
  two: {corners: [d, c, b, a]}
blocks:
  cube: {corners: [a, b, c, d, e, f, g, h]}
)";
    CHECK(faults(text) ==
          R"(19: error: kmin of block 'cube' has several faces between its corners: 'one' and 'two'
  hint: give the block by its six faces
)");
}

TEST_CASE("A face with a block's corners and other edges is not overlooked") {
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
  m: [0.5, 0, 0]
edges:
  ab: {from: a, to: b, cells: 4}
  ad: {from: a, to: d, cells: 5}
  ae: {from: a, to: e, cells: 6}
  am: {from: a, to: m}
  mb: {from: m, to: b}
faces:
  split: {imin: ad, imax: c-b, jmin: [am, mb], jmax: c-d}
blocks:
  cube: {corners: [a, b, c, d, e, f, g, h]}
)";
    CHECK(faults(text) ==
          R"(21: error: kmin of block 'cube' has the corners of face 'split', but other edges
  hint: give the block by its six faces
)");
}

TEST_CASE("A face is a side of two blocks at most") {
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
blocks:
  one: {corners: [a, b, c, d, e, f, g, h]}
  two: {corners: [a, b, c, d, e, f, g, h]}
  three: {corners: [a, b, c, d, e, f, g, h]}
)";
    CHECK(faults(text) ==
          R"(16: error: face 'a-d-h-e' is used 3 times, by blocks 'one', 'two' and 'three'
  hint: at most two blocks share one face
16: error: face 'b-c-g-f' is used 3 times, by blocks 'one', 'two' and 'three'
  hint: at most two blocks share one face
16: error: face 'a-b-f-e' is used 3 times, by blocks 'one', 'two' and 'three'
  hint: at most two blocks share one face
16: error: face 'c-d-h-g' is used 3 times, by blocks 'one', 'two' and 'three'
  hint: at most two blocks share one face
16: error: face 'a-b-c-d' is used 3 times, by blocks 'one', 'two' and 'three'
  hint: at most two blocks share one face
16: error: face 'e-f-g-h' is used 3 times, by blocks 'one', 'two' and 'three'
  hint: at most two blocks share one face
)");
}

namespace {

const std::array<std::string, 8> right_cube{"b", "j", "k", "c", "f", "l", "o", "g"};

/// The rotations of a hexahedron: corner n of the rotated one is corner rotation[n] of the other.
std::vector<std::array<std::size_t, 8>> rotations() {
    std::vector<std::array<std::size_t, 8>> result;
    std::array<int, 3> axes{0, 1, 2};
    do {
        for (int flips = 0; flips < 8; ++flips) {
            Orientation o;
            for (std::size_t a = 0; a < 3; ++a) {
                const int axis = axes[a] + 1;
                o.axes[a] = ((flips >> a) & 1) != 0 ? -axis : axis;
            }
            if (determinant(o) < 0) continue;
            std::array<std::size_t, 8> rotation{};
            for (int k = 0; k < 2; ++k) {
                for (int j = 0; j < 2; ++j) {
                    for (int i = 0; i < 2; ++i) {
                        const Node other = map_node(o, {i, j, k}, {2, 2, 2});
                        rotation[hexahedron_corner(i, j, k)] =
                            hexahedron_corner(other[0], other[1], other[2]);
                    }
                }
            }
            result.push_back(rotation);
        }
    } while (std::next_permutation(axes.begin(), axes.end()));
    return result;
}

const std::string two_cubes = R"(
vertices: {a: [0, 0, 0], b: [1, 0, 0], c: [1, 1, 0], d: [0, 1, 0], e: [0, 0, 1], f: [1, 0, 1], g: [1, 1, 1], h: [0, 1, 1], j: [2, 0, 0], k: [2, 1, 0], l: [2, 0, 1], o: [2, 1, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  bj: {from: b, to: j, cells: 3}
  cb: {from: c, to: b, cells: 5, spacing: {start: 0.1}}
  fb: {from: f, to: b, cells: 6, spacing: {start: 0.2}}
)";

}  // namespace

TEST_CASE("Two blocks by corners meet in every orientation") {
    REQUIRE(rotations().size() == 24);
    for (const auto& rotation : rotations()) {
        std::string corners;
        for (const std::size_t n : rotation) {
            corners += corners.empty() ? "" : ", ";
            corners += right_cube[n];
        }
        const std::string text = two_cubes + fmt::format(R"(
blocks:
  left:  {{corners: [a, b, c, d, e, f, g, h]}}
  right: {{corners: [{}]}}
)",
                                                         corners);
        INFO(corners);
        const Topology t = resolved(text);
        CHECK(broken_promise(t) == "");
        CHECK(t.faces.size() == 11);
        CHECK(t.edges.size() == 20);
        CHECK(t.cells() == (4UL + 3) * 5 * 6);
        CHECK(t.boundaries[0].sides.size() == 10);
        CHECK(law_text(t, named(t.edges, "k-o")) == "same as -fb");
    }
}

TEST_CASE("The faces of a block find their places from any orientation of its axes") {
    // The faces of the right cube, by the corners (b, ..., g) that they have.
    const std::string faces = R"(
faces:
  f0: {corners: [b, c, g, f]}
  f1: {corners: [o, l, j, k]}
  f2: {imin: j-l, imax: fb, jmin: bj, jmax: f-l}
  f3: {corners: [k, c, g, o]}
  f4: {corners: [b, j, k, c]}
  f5: {corners: [g, o, l, f]}
)";
    const std::array<std::string, 6> corners_of{"bcfg", "jklo", "bfjl", "cgko", "bcjk", "fglo"};
    for (const auto& rotation : rotations()) {
        std::string sides;
        for (const Side side : all_sides) {
            std::string corners;
            for (const std::size_t n : corners_of_side(side)) corners += right_cube[rotation[n]];
            std::sort(corners.begin(), corners.end());
            const auto* const face = std::find(corners_of.begin(), corners_of.end(), corners);
            REQUIRE(face != corners_of.end());
            if (!sides.empty()) sides += ", ";
            sides += fmt::format("{}: f{}", side_name(side), face - corners_of.begin());
        }
        INFO(sides);
        const Topology t =
            resolved(two_cubes + faces + fmt::format("blocks:\n  right: {{{}}}\n", sides));
        CHECK(broken_promise(t) == "");
        std::string corners;
        for (const std::size_t n : rotation) {
            corners += corners.empty() ? "" : " ";
            corners += right_cube[n];
        }
        CHECK(corner_text(t, t.blocks[0].corners) == corners);
    }
}
