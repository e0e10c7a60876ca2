// SPDX-License-Identifier: Apache-2.0
// Resolving: sides of a face that cross, and sides that only come near each other.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <string>

#include "topology/resolve_helpers.h"

using namespace hexweave;

namespace {

/// A channel of height 1 over a floor from (0, 0) to (1, 0), and what lies below it.
std::string channel(const std::string& x, const std::string& y) {
    return fmt::format(R"(
curves:
  hump: {{formula: ["{}", "{}"], range: [0, 1]}}
vertices: {{a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [0, -2], f: [1, -2]}}
edges:
  floor: {{from: a, to: b, along: hump, cells: 8}}
  left: {{from: a, to: d, cells: 4}}
  under: {{from: e, to: a, cells: 4}}
faces:
  above: {{corners: [a, b, c, d]}}
  below: {{corners: [e, f, b, a]}}
boundaries:
  all: {{type: BCWall, sides: [left, b-c, c-d, under, e-f, b-f]}}
)",
                       x, y);
}

/// A strip between two curves over x from 0 to 1, drawn with different parameters.
std::string strip(const std::string& gap) {
    return fmt::format(R"(
curves:
  low: {{formula: [t, 0.1 * sin(3 * pi * t)], range: [0, 1]}}
  high: {{formula: [t^2, "0.1 * sin(3 * pi * t^2) + {}"], range: [0, 1]}}
vertices: {{a: [0, 0], b: {{curve: low, at: 1}}, c: {{curve: high, at: 1}}, d: {{curve: high, at: 0}}}}
edges:
  low: {{from: a, to: b, along: low, cells: 8}}
  high: {{from: d, to: c, along: high}}
  left: {{from: a, to: d, cells: 4}}
  right: {{from: b, to: c}}
faces:
  f: {{imin: left, imax: right, jmin: low, jmax: high}}
boundaries:
  all: {{type: BCWall, sides: [low, high, left, right]}}
)",
                       gap);
}

/// A box on the vectors (1, 1, 0), (-1, 1, 0) and (0, 0, 1), one of whose edges is a curve.
std::string box(const std::string& x, const std::string& y, const std::string& z,
                const std::string& corners = "a, b, c, d, e, f, g, h") {
    return fmt::format(R"(
curves:
  hump: {{formula: ["{}", "{}", "{}"], range: [0, 1]}}
vertices: {{a: [0, 0, 0], b: [1, 1, 0], c: [0, 2, 0], d: [-1, 1, 0], e: [0, 0, 1], f: [1, 1, 1], g: [0, 2, 1], h: [-1, 1, 1]}}
edges:
  ab: {{from: a, to: b, along: hump, cells: 2}}
  ad: {{from: a, to: d, cells: 2}}
  ae: {{from: a, to: e, cells: 2}}
blocks:
  cube: {{corners: [{}]}}
)",
                       x, y, z, corners);
}

}  // namespace

// 5 t (1 - t) is 1 where t = (1 - 1 / sqrt(5)) / 2.
TEST_CASE("Sides that cross are told by their edges and the place") {
    CHECK(
        faults(channel("t", "5 * t * (1 - t)")) ==
        R"(10: error: edges 'floor' and 'c-d' of face 'above' cross at [0.276393, 1]: no grid can lie between its sides
  6: 'floor' is drawn here
  hint: the sides of a face meet in its corners alone: move one of the two
)");
    CHECK(faults(channel("t", "3.9 * t * (1 - t)")).empty());
}

// The floor leaves to the left of `left` and crosses it where t = 1e-3 (1 - t), y = 0.1 t (1 - t).
TEST_CASE("Sides that cross close to the corner that they share are told") {
    CHECK(
        faults(channel("t^2 - 1e-3 * t * (1 - t)", "0.1 * t * (1 - t)")) ==
        R"(10: error: edges 'floor' and 'left' of face 'above' cross at [0, 9.9798e-05]: no grid can lie between its sides
  6: 'floor' is drawn here
  7: 'left' is drawn here
  hint: the sides of a face meet in its corners alone: move one of the two
)");
}

// With s = 2 t - 1, x is 1/2 and y is 9/40 both for s = 1/2 and for s = -1/2.
TEST_CASE("A side that crosses itself is told once, though two faces have it") {
    CHECK(
        faults(channel("0.5 + ((2 * t - 1)^3 - (2 * t - 1) / 4) * 2 / 3",
                       "0.3 * (1 - (2 * t - 1)^2)")) ==
        R"(10: error: edge 'floor' of face 'above' crosses itself at [0.5, 0.225]: no grid can lie between its sides
  6: 'floor' is drawn here
  hint: draw it so that it does not
)");
}

TEST_CASE("Sides with a thin gap between them do not cross, however they are sampled") {
    CHECK(faults(strip("1e-3")).empty());
    CHECK(faults(strip("1e-6")).find("cross") == std::string::npos);
    CHECK(first_error(strip("1e-3 * cos(2 * pi * t)"))
              .find("edges 'low' and 'high' of face 'f' "
                    "cross at [0.0625, ") != std::string::npos);
}

TEST_CASE("Sides that run along each other do not cross") {
    CHECK(faults(R"(
curves:
  bow: {arc: {center: [1, 0], radius: 3, from: pi/2, to: 3*pi/2}}
  over: {formula: [t, 0.1 * sin(pi * t)], range: [0, 1]}
  under: {formula: [t, -0.1 * sin(pi * t)], range: [0, 1]}
  first: {formula: [1 + 3 * t, sin(2 * t)], range: [0, 1]}
  second: {formula: [1 + 3 * t^3, sin(2 * t^3)], range: [0, 1]}
vertices: {nose: [0, 0], tail: [1, 0], out: {curve: first, at: 1}, high: [4, 3], low: [4, -3], front_high: [1, 3], front_low: [1, -3]}
edges:
  over: {from: nose, to: tail, along: over, cells: 16}
  under: {from: nose, to: tail, along: under, cells: 16}
  first: {from: tail, to: out, along: first, cells: 8}
  second: {from: tail, to: out, along: second, cells: 8}
  top: {from: front_high, to: high, cells: 8}
  bottom: {from: front_low, to: low, cells: 8}
  bow: {from: front_low, to: front_high, along: bow}
  up: {from: out, to: high, cells: 8}
  down: {from: out, to: low}
faces:
  c: {jmin: [first, under, over, second], jmax: [bottom, bow, top], imin: down, imax: up}
boundaries:
  all: {type: BCWall, sides: [bottom, bow, down, over, top, under, up, first, second]}
)")
              .empty());
}

TEST_CASE("Sides that cross are told in any plane") {
    CHECK(
        first_error(box("t", "t", "5 * t * (1 - t)")) ==
        R"(10: error: edges 'ab' and 'e-f' of face 'a-b-f-e' cross at [0.276393, 0.276393, 1]: no grid can lie between its sides
  6: 'ab' is drawn here
  hint: the sides of a face meet in its corners alone: move one of the two
)");
    CHECK(first_error(box("t + t * (1 - t) / 100", "t - t * (1 - t) / 100", "5 * t * (1 - t)"))
              .empty());
}

TEST_CASE("Corners of a block whose edges cross are told in their order") {
    CHECK(
        first_error(box("t", "t", "0", "a, b, d, c, e, f, g, h")) ==
        R"(10: error: edges 'd-g' and 'c-h' of face 'c-d-g-h' cross at [-0.5, 1.5, 0.5]: no grid can lie between its sides
  hint: four corners round one side, then those above them in the same order: [a, b, c, d, e, f, g, h]
)");
}

TEST_CASE("An edge that takes the long way is named where the corners are in order") {
    CHECK(faults(R"(
curves:
  rim: {circle: {center: [0, 0], radius: 1}}
vertices: {a: [0.3, 0], b: [1, 0], c: [0, 1], d: [0, 0.3]}
edges:
  rim: {from: b, to: c, along: rim, through: [-1, 0], cells: 8}
  left: {from: a, to: d, cells: 8}
  ab: {from: a, to: b, cells: 8}
faces:
  f: {corners: [a, b, c, d]}
boundaries:
  all: {type: BCWall, sides: [rim, left, ab, c-d]}
)") ==
          R"(10: error: face 'f' is left-handed: seen from +z, i to j turns clockwise
  hint: its corners are in order, but edge 'rim' takes a way 3.3 times as long as the straight one: see its 'through'
)");
}
