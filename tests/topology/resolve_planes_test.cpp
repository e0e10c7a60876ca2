// SPDX-License-Identifier: Apache-2.0
// Edges with a plane: exactly there, or told how far off they are.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "topology/resolve_helpers.h"

using namespace hexweave;

namespace {

/// A block whose edge `bow` is an arch that leaves the plane z = 0 by 1e-4 in its middle; `key` is
/// what the edge has to say of its plane.
std::string arched(const std::string& key) {
    return R"(
curves:
  arch: {formula: [t, t * (1 - t), 4e-4 * t * (1 - t)], range: [0, 1]}
vertices: {a: [0, 0, 0], b: [1, 0, 0], c: [1, 1, 0], d: [0, 1, 0], e: [0, 0, 1], f: [1, 0, 1], g: [1, 1, 1], h: [0, 1, 1]}
edges:
  bow: {from: a, to: b, along: arch, cells: 4)" +
           key + R"(}
  ad: {from: a, to: d, cells: 5}
  ae: {from: a, to: e, cells: 6}
blocks:
  cube: {corners: [a, b, c, d, e, f, g, h]}
boundaries:
  wall: {type: BCWall, sides: [a-b-c-d, c-d-h-g, e-f-g-h, a-b-f-e, b-c-g-f, a-d-h-e]}
)";
}

}  // namespace

TEST_CASE("an edge with a plane is on that plane, and how far it moved is told") {
    const Topology arch = resolved(arched(""));
    CHECK(named(arch.edges, "bow").planes.empty());
    CHECK(arch.put_on_surface.empty());
    const Topology t = resolved(arched(R"(, plane: "z = 0", gap: 1.01e-4)"));
    REQUIRE(named(t.edges, "bow").planes.size() == 1);
    CHECK(named(t.edges, "bow").planes[0].axis == 2);
    CHECK(named(t.edges, "bow").planes[0].value == 0);
    REQUIRE(t.put_on_surface.size() == 1);
    CHECK(t.put_on_surface[0].what == "edge 'bow'");
    CHECK(t.put_on_surface[0].surfaces == "plane z = 0");
    CHECK(t.put_on_surface[0].distance == Approx(1e-4).epsilon(1e-12));
    CHECK(distance(t.put_on_surface[0].place, {0.5, 0.25, 1e-4}) < 1e-12);
}

TEST_CASE("an edge farther off its plane than is allowed is told how far and where") {
    CHECK(faults(arched(R"(, plane: "z = 0", gap: 0.99e-4)")) ==
          "6: error: edge 'bow' is not on the plane z = 0: it is 0.0001 away at [0.5, 0.25, "
          "0.0001]\n  hint: it may be as far as 'gap' says\n");
    CHECK(faults(arched(R"(, plane: "z = 0")")) ==
          "6: error: edge 'bow' is not on the plane z = 0: it is 0.0001 away at [0.5, 0.25, "
          "0.0001]\n  hint: it may be 1e-9 of the size of the grid away, or as far as 'gap' "
          "allows\n");
    CHECK(first_error(arched(R"(, plane: "y = 1")")) ==
          "6: error: edge 'bow' is not on the plane y = 1: it is 1 away at [0, 0]\n  hint: it may "
          "be 1e-9 of the size of the grid away, or as far as 'gap' allows\n");
}

TEST_CASE("a plane of an edge that cannot be read is told, and a gap without one is refused") {
    CHECK(faults(arched(", plane: z")) ==
          "6: error: 'plane' must be an axis and its value, not 'z'\n"
          "  hint: write \"z = 0\", or x or y for z\n");
    CHECK(faults(arched(", gap: 1e-4")) ==
          "6: error: 'gap' is for edges on surfaces\n"
          "  hint: name the 'surface', or remove 'gap'\n");
}

TEST_CASE("straight edges follow vertices that were moved onto a plane, edges on surfaces do not") {
    const Topology t = resolved(R"(
surfaces:
  tube: {cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 1}}
vertices:
  a: {surface: tube, at: [0, 0]}
  b: {surface: tube, at: [1, 0]}
  c: {surface: tube, near: [cos(1), sin(1), 1]}
  d: [1, 1e-8, 1]
edges:
  ab: {from: a, to: b, surface: tube, cells: 8}
  bc: {from: b, to: c, surface: tube, cells: 4}
  dc: {from: d, to: c, surface: tube, gap: 1e-6}
  ad: {from: a, to: d, plane: "y = 0", gap: 1e-7}
faces:
  f: {corners: [a, b, c, d], surface: tube}
boundaries:
  rim: {type: BCWall, sides: [ab, bc, dc, ad]}
)");
    CHECK(named(t.vertices, "d").position == Vec3{1, 0, 1});
    CHECK(evaluate(*named(t.edges, "ad").curve, 1) == Vec3{1, 0, 1});
    CHECK(norm(evaluate(*named(t.edges, "ad").curve, 0.5) - Vec3{1, 0, 0.5}) < 1e-15);
    const Vec3 middle = evaluate(*named(t.edges, "ab").curve, 0.5);
    CHECK(std::hypot(middle.x, middle.y) == Approx(1).epsilon(1e-14));
}

TEST_CASE("a plane that a whole boundary is off is told once, with the right one") {
    std::string text = arched("");
    text.replace(text.find("sides: [a-b-c-d, c-d-h-g, e-f-g-h, "), 35,
                 "sides: [a-b-c-d, c-d-h-g, ");
    text += "  lid: {type: BCInflow, plane: \"z = 2\", sides: e-f-g-h}\n";
    CHECK(faults(text) ==
          "13: error: edge 'e-f' is 1 off the plane z = 2, and so are 3 more of boundary 'lid'\n"
          "  hint: they are on the plane z = 1: write that\n");
}
