// SPDX-License-Identifier: Apache-2.0
// Resolving: sides of blocks made of several faces.
#include <catch2/catch.hpp>
#include <string>

#include "topology/resolve_helpers.h"

using namespace hexweave;

namespace {

//      h ------------- g       A box whose side jmin is the strip s1, s2; its edges a-b and e-f are
//     /|              /|       divided by m and o.
//    e ----- o ----- f |
//    | d ----|-------|-c
//    |/  s1  |  s2   |/
//    a ----- m ----- b
const std::string box = R"(
vertices: {a: [0, 0, 0], m: [1, 0, 0], b: [2, 0, 0], c: [2, 1, 0], d: [0, 1, 0], e: [0, 0, 1], o: [1, 0, 1], f: [2, 0, 1], g: [2, 1, 1], h: [0, 1, 1]}
edges:
  am: {from: a, to: m, cells: 2}
  mb: {from: m, to: b, cells: 3}
  eo: {from: e, to: o}
  of: {from: o, to: f}
  ad: {from: a, to: d, cells: 4}
  ae: {from: a, to: e, cells: 5}
  ef: {from: e, to: f}
faces:
  s1: {corners: [a, m, o, e]}
  s2: {corners: [b, m, o, f]}
  north: {corners: [d, c, g, h]}
  west: {corners: [a, d, h, e]}
  east: {corners: [b, c, g, f]}
  floor: {imin: ad, imax: b-c, jmin: [am, mb], jmax: c-d}
  roof: {imin: e-h, imax: f-g, jmin: [eo, of], jmax: g-h}
  roof_alone: {imin: e-h, imax: f-g, jmin: ef, jmax: g-h}
)";

std::string box_with(const std::string& jmin, const std::string& kmax = "roof") {
    return box + "blocks:\n  b: {imin: west, imax: east, jmin: " + jmin +
           ", jmax: north, kmin: floor, kmax: " + kmax + "}\n";
}

const std::string with_boundary =
    "boundaries: {all: {type: BCWall, sides: [s1, s2, north, west, east, floor, roof]}}\n";

/// The faults of a box without the warnings of what is not used.
std::string errors(const std::string& text) {
    std::string all = faults(text);
    std::string kept;
    bool warning = false;
    for (std::size_t at = 0; at < all.size();) {
        const std::size_t end = all.find('\n', at) + 1;
        const std::string line = all.substr(at, end - at);
        if (line[0] != ' ') warning = line.find(": warning: ") != std::string::npos;
        if (!warning) kept += line;
        at = end;
    }
    return kept;
}

}  // namespace

TEST_CASE("The direction of a strip follows from the edges") {
    for (const std::string jmin : {"[s1, s2]", "[[s1, s2]]"}) {
        const Topology t = resolved(box_with(jmin) + with_boundary);
        CHECK(broken_promise(t) == "");
        const BlockSide& side = t.blocks[0].side(Side::jmin);
        REQUIRE(side.columns == 2);
        REQUIRE(side.faces.size() == 2);
        CHECK(t.faces[static_cast<std::size_t>(side.at(0, 0).face)].name == "s1");
        CHECK(side.at(0, 0).orientation == Orientation{{1, 2, 3}});
        CHECK(side.at(1, 0).orientation == Orientation{{-1, 2, 3}});
        CHECK(side.at(1, 0).begin == std::array{2, 0});
        CHECK(t.blocks[0].extent == Extent{6, 5, 6});
    }
}

TEST_CASE("A strip listed against its axis is told the other order") {
    CHECK(
        errors(box_with("[s2, s1]")) ==
        R"(21: error: block 'b' does not close: 'west' (imin) and 's2' and 's1' (jmin) share no edge
  21: nor do 'east' (imax) and 's2' and 's1' (jmin)
  hint: with the faces in another order it does: 'jmin: [s1, s2]'
)");
}

TEST_CASE("Rows that run along the wrong axis are shown turned") {
    CHECK(
        errors(box_with("[[s1], [s2]]")) ==
        R"(21: error: block 'b' does not close: 'west' (imin) and 's1' and 's2' (jmin) share no edge
  21: nor do 'east' (imax) and 's1' and 's2' (jmin)
  21: nor do 's1' and 's2' (jmin) and 'floor' (kmin)
  21: nor do 's1' and 's2' (jmin) and 'roof' (kmax)
  hint: with the faces in another order it does: 'jmin: [[s1, s2]]'
)");
}

TEST_CASE("A face that shares nothing with its neighbour is named") {
    CHECK(
        errors(box_with("[s1, north]")) ==
        R"(21: error: jmin of block 'b' does not fit together: 's1' and 'north' have no side in common
  hint: faces beside each other on a side of a block have one side, edge for edge, in common
)");
}

TEST_CASE("Faces that share a part of a side are told what each has") {
    CHECK(errors(box_with("[s1, s2]") + "  c: {imin: west, imax: east, jmin: [s1, floor], "
                                        "jmax: north, kmin: [[roof], [s1]], kmax: roof}\n") ==
          R"(22: error: face 's1' is on the adjacent sides jmin and kmin of block 'c'
  hint: a cut is on opposite sides
)");
    CHECK(
        errors(box_with("[s1, s2]") +
               "  c: {imin: west, imax: east, jmin: [s1, floor], jmax: north, kmin: roof, kmax: "
               "s2}\n") ==
        R"(22: error: jmin of block 'c' does not fit together: 's1' and 'floor' have no side in common
  22: the side of 's1' is made of 'am', that of 'floor' of 'am' and 'mb'
  hint: faces beside each other on a side of a block have one side, edge for edge, in common
)");
}

TEST_CASE("A split edge meets one split alike") {
    CHECK(
        errors(box_with("[s1, s2]", "roof_alone")) ==
        R"(21: error: block 'b' does not close: 's1' and 's2' (jmin) and 'roof_alone' (kmax) share no edge
  21: jmin has 'eo' and 'of' there, kmax has 'ef'
  hint: faces on adjacent sides of a block have one side, edge for edge, in common
)");
    CHECK(errors(box_with("s1")) ==
          R"(21: error: block 'b' does not close: 'east' (imax) and 's1' (jmin) share no edge
  21: nor do 's1' (jmin) and 'floor' (kmin): jmin has 'am' there, kmin has 'am' and 'mb'
  21: nor do 's1' (jmin) and 'roof' (kmax): jmin has 'eo' there, kmax has 'eo' and 'of'
  hint: faces on adjacent sides of a block have one side, edge for edge, in common
)");
}

TEST_CASE("Axes of faces in a strip that contradict the edges are refused") {
    CHECK(errors(box_with("[{face: s1, axes: [j, i]}, s2]")) ==
          R"(21: error: 'axes: [j, i]' of 's1' (jmin) contradict the edges of block 'b'
  hint: the edges ask for 'axes: [i, j]'
)");
    CHECK(errors(box_with("[{face: s1, axes: [i, j]}, {face: s2, axes: [i, j]}]")) ==
          R"(21: error: 'axes: [i, j]' of 's2' (jmin) contradict the edges of block 'b'
  hint: the edges ask for 'axes: [-i, j]'
)");
    CHECK(errors(box_with("[{face: s1, axes: [i, j]}, {face: s2, axes: [-i, j]}]") +
                 with_boundary) == "");
}

TEST_CASE("Faces that share edges but make no rectangle are told so") {
    CHECK(
        errors(box_with("[[s1, s2], [s2, s1]]")) ==
        R"(21: error: jmin of block 'b' does not fit together: 's2' shares a side with each neighbour before it, but they do not lie in a rectangle
  hint: rows run along i and follow each other along k
)");
    CHECK(
        errors(box_with("[s1, s2, s1]")) ==
        R"(21: error: jmin of block 'b' does not fit together: 's1' shares a side with each neighbour before it, but they do not lie in a rectangle
  hint: in a strip, a face meets the next one on the side opposite to the one before
)");
}
