// SPDX-License-Identifier: Apache-2.0
// Faces on surfaces: what a file may say of them, and what is said of edges that are off them.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "topology/handedness.h"
#include "topology/resolve_helpers.h"

using namespace hexweave;

namespace {

/// A square face in the plane z = 0, its right side `bulge` above it in the middle.
std::string square_with(const std::string& surfaces, const std::string& surface,
                        const std::string& bulge = "0") {
    return R"(
curves:
  right: {formula: [1, t, )" +
           bulge + R"( * t * (1 - t)], range: [0, 1]}
surfaces:
)" + surfaces +
           R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1]}
edges:
  ab: {from: a, to: b, cells: 4}
  bc: {from: b, to: c, along: right, cells: 4}
faces:
  f: {corners: [a, b, c, d], surface: )" +
           surface + R"(}
boundaries:
  rim: {type: BCWall, sides: [ab, bc, c-d, a-d]}
)";
}

const std::string floor_and_ball = R"(  floor: {plane: {point: [-1, -1], u: [3, 0], v: [0, 3]}}
  ball: {sphere: {center: [0, 0, 0], radius: 1}}
)";

/// A block over the upper half of a ball: all its edges lie in the plane z = 0. `order` are its
/// sides kmin and kmax.
std::string dome(const std::string& order) {
    return R"(
parameters: {inner: 1, outer: 3, d: sqrt(0.5)}
curves:
  small: {circle: {center: [0, 0], radius: inner}}
  large: {circle: {center: [0, 0], radius: outer}}
surfaces:
  cap: {formula: [2 * u / (1 + u^2 + v^2), 2 * v / (1 + u^2 + v^2), (1 - u^2 - v^2) / (1 + u^2 + v^2)], u: [-1, 1], v: [-1, 1]}
  sky: {of: cap, scale: outer}
vertices:
  a: [-inner * d, -inner * d]
  b: [inner * d, -inner * d]
  c: [inner * d, inner * d]
  e: [-inner * d, inner * d]
  A: [-outer * d, -outer * d]
  B: [outer * d, -outer * d]
  C: [outer * d, outer * d]
  E: [-outer * d, outer * d]
edges:
  ab: {from: a, to: b, along: small, through: [0, -inner], cells: 4}
  bc: {from: b, to: c, along: small, through: [inner, 0], cells: 4}
  ec: {from: e, to: c, along: small, through: [0, inner]}
  ae: {from: a, to: e, along: small, through: [-inner, 0]}
  AB: {from: A, to: B, along: large, through: [0, -outer]}
  BC: {from: B, to: C, along: large, through: [outer, 0]}
  EC: {from: E, to: C, along: large, through: [0, outer]}
  AE: {from: A, to: E, along: large, through: [-outer, 0]}
  up: {from: a, to: A, cells: 3}
faces:
  inside:  {imin: ae, imax: bc, jmin: ab, jmax: ec, surface: cap}
  outside: {imin: AE, imax: BC, jmin: AB, jmax: EC, surface: sky}
  west:    {corners: [a, A, E, e]}
  east:    {corners: [b, B, C, c]}
  south:   {corners: [a, A, B, b]}
  north:   {corners: [e, E, C, c]}
blocks:
  over: {imin: west, imax: east, jmin: south, jmax: north, )" +
           order + "}\n";
}

}  // namespace

TEST_CASE("a face finds the surface that it names") {
    const Topology t = resolved(square_with(floor_and_ball, "floor"));
    REQUIRE(t.faces[0].surface != nullptr);
    CHECK(evaluate(*t.faces[0].surface, {1, 1}) == Vec3{2, 2, 0});
    CHECK(t.planar);
    CHECK(resolved(square_with(floor_and_ball, "minimal")).faces[0].surface == nullptr);
}

TEST_CASE("a surface that no face names is warned of") {
    CHECK(faults(square_with(floor_and_ball, "floor")) ==
          "6: warning: surface 'ball' is not used\n");
    CHECK(faults(square_with("  floor: {plane: {point: [-1, -1], u: [3, 0], v: [0, 3]}}\n"
                             "  moved: {of: floor, translate: [0, 0, 0]}\n",
                             "moved")) == "");
}

TEST_CASE("a face over a dome is not planar though its edges are") {
    const std::string bubble =
        "  bubble: {formula: [u, v, 16 * u * v * (1 - u) * (1 - v)], u: [0, 1], v: [0, 1]}\n";
    CHECK_FALSE(resolved(square_with(bubble, "bubble")).planar);
}

TEST_CASE("an unknown surface is told with the nearest name") {
    CHECK(first_error(square_with(floor_and_ball, "flor")) ==
          "13: error: unknown surface 'flor'\n  hint: did you mean 'floor'?\n");
}

TEST_CASE("an edge off the surface of its face is told how far and where") {
    CHECK(faults(square_with("  floor: {plane: {point: [-1, -1], u: [3, 0], v: [0, 3]}}\n", "floor",
                             "0.4")) ==
          "12: error: edge 'bc' is not on the surface 'floor': it is 0.1 away at [1, 0.5, 0.1]\n"
          "  10: the edge stands here\n"
          "  hint: the nearest point of the surface is [1, 0.5], at u = 0.666667, v = 0.5\n");
    // Less than 1e-6 of the surface's size is not.
    CHECK(faults(square_with("  floor: {plane: {point: [-1, -1], u: [3, 0], v: [0, 3]}}\n", "floor",
                             "1.6e-5")) == "");
}

TEST_CASE("a face whose boundary goes round its surface is refused") {
    const std::string text = R"(
curves:
  equator: {circle: {center: [0, 0], radius: 1}}
surfaces:
  ball: {sphere: {center: [0, 0, 0], radius: 1}}
vertices: {a: [1, 0], b: [0, 1], c: [-1, 0], d: [0, -1]}
edges:
  ab: {from: a, to: b, along: equator, through: [1, 1], cells: 4}
  bc: {from: b, to: c, along: equator, through: [-1, 1], cells: 4}
  cd: {from: c, to: d, along: equator, through: [-1, -1]}
  da: {from: d, to: a, along: equator, through: [1, -1]}
faces:
  north: {corners: [a, b, c, d], surface: ball}
boundaries:
  rim: {type: BCWall, sides: [ab, bc, cd, da]}
)";
    CHECK(first_error(text).find("13: error: the boundary of face 'north' goes round the surface "
                                 "'ball'\n  hint: on the way round") == 0);
}

TEST_CASE("handedness counts the surfaces of a block whose edges all lie in one plane") {
    CHECK(first_error(dome("kmin: inside, kmax: outside")) == "");
    CHECK(first_error(dome("kmin: outside, kmax: inside")).find("block 'over' is left-handed") !=
          std::string::npos);
    const Topology t = resolved(dome("kmin: inside, kmax: outside"));
    CHECK(signed_volume(t, t.blocks[0]) == Approx(2 * std::acos(-1.0) / 3 * 26).epsilon(0.01));
}
