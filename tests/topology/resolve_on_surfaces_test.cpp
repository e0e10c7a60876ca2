// SPDX-License-Identifier: Apache-2.0
// Vertices and edges on surfaces, and faces over several: where they are, and what is said when
// they are not.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "topology/resolve_helpers.h"

using namespace hexweave;

namespace {

const double pi = std::acos(-1.0);

/// A ball in two halves, y >= 0 and y <= 0, and whole; and a rectangle on it.
std::string on_ball(const std::string& vertices, const std::string& edges,
                    const std::string& surface) {
    return R"(
curves:
  chord: {line: [[1, -0.6, 0], [1, 0.6, 0]]}
surfaces:
  right: {formula: [cos(u) * cos(v), sin(u) * cos(v), sin(v)], u: [0, pi], v: [-pi/2, pi/2]}
  left: {of: right, mirror: {normal: [0, 1, 0]}}
  ball: {sphere: {center: [0, 0], radius: 1}}
vertices:
)" + vertices +
           "edges:\n" + edges + R"(
faces:
  f: {imin: da, imax: bc, jmin: ab, jmax: cd, surface: )" +
           surface + R"(}
boundaries:
  rim: {type: BCWall, sides: [ab, bc, cd, da]}
)";
}

const std::string near_corners = R"(  a: {surface: [right, left], near: [1, -0.6, 0]}
  b: {surface: [right, left], near: [1, 0.6, 0]}
  c: {surface: [right, left], near: [1, 0.6, 0.5]}
  d: {surface: [right, left], near: [1, -0.6, 0.5]}
)";

const std::string edges_on_halves =
    R"(  ab: {from: a, to: b, along: chord, surface: [right, left], cells: 4}
  bc: {from: b, to: c, surface: right, cells: 4}
  cd: {from: d, to: c, surface: [right, left]}
  da: {from: a, to: d, surface: left}
)";

double worst_radius(const Edge& edge) {
    double worst = 0;
    for (int n = 0; n <= 50; ++n) {
        const double t = edge.from + (edge.to - edge.from) * n / 50;
        worst = std::max(worst, std::abs(norm(evaluate(*edge.curve, t)) - 1));
    }
    return worst;
}

}  // namespace

TEST_CASE("vertices and edges are put onto several surfaces, and the distance is told") {
    const Topology t = resolved(on_ball(near_corners, edges_on_halves, "[right, left]"));
    CHECK(t.faces[0].surface == nullptr);
    CHECK(t.faces[0].patches.size() == 2);
    for (const Vertex& v : t.vertices) CHECK(norm(v.position) == Approx(1).epsilon(1e-14));
    for (const Edge& e : t.edges) {
        CHECK(worst_radius(e) < 1e-13);
        const Vec3 start = t.vertices[static_cast<std::size_t>(e.start)].position;
        const Vec3 end = t.vertices[static_cast<std::size_t>(e.end)].position;
        CHECK(distance(evaluate(*e.curve, e.from), start) < 1e-11);
        CHECK(distance(evaluate(*e.curve, e.to), end) < 1e-11);
    }
    REQUIRE(t.put_on_surface.size() == 5);
    CHECK(t.put_on_surface[0].what == "vertex 'a'");
    CHECK(t.put_on_surface[0].surfaces == "surface 'left'");
    CHECK(t.put_on_surface[0].distance == Approx(std::sqrt(1.36) - 1));
    CHECK(t.put_on_surface[4].what == "edge 'ab'");
    CHECK(t.put_on_surface[4].distance == Approx(std::sqrt(1.36) - 1));
    // A chord through the equator's plane becomes a piece of the equator.
    CHECK(named(t.edges, "ab").length == Approx(2 * std::atan(0.6)).epsilon(1e-9));
}

TEST_CASE("an edge without a curve is the line between its parameters, the short way round") {
    const std::string vertices = R"(  a: {surface: ball, at: [-0.5, 0]}
  b: {surface: ball, at: [0.5, 0]}
  c: {surface: ball, at: [0.5, 0.7]}
  d: {surface: ball, near: [cos(0.5) * cos(0.7), -sin(0.5) * cos(0.7), sin(0.7)]}
)";
    const std::string edges = R"(  ab: {from: a, to: b, surface: ball, cells: 4}
  bc: {from: b, to: c, surface: ball, cells: 4}
  cd: {from: d, to: c, surface: ball}
  da: {from: a, to: d, surface: ball}
)";
    const Topology t = resolved(on_ball(vertices, edges, "ball"));
    CHECK(named(t.edges, "ab").length == Approx(1).epsilon(1e-12));
    CHECK(named(t.edges, "cd").length == Approx(std::cos(0.7)).epsilon(1e-10));
    CHECK(named(t.edges, "bc").length == Approx(0.7).epsilon(1e-12));
    for (const Edge& e : t.edges) CHECK(worst_radius(e) < 1e-14);
}

TEST_CASE("stated parameters choose the long way round") {
    const std::string text = R"(
surfaces:
  tube: {cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 1}}
vertices:
  a: {surface: tube, at: [0.5, 0]}
  b: {surface: tube, at: [6, 0]}
  c: {surface: tube, at: [6, 1]}
  d: {surface: tube, at: [0.5, 1]}
edges:
  ab: {from: a, to: b, surface: tube, cells: 8}
  bc: {from: b, to: c, cells: 4}
  dc: {from: d, to: c, surface: tube}
faces:
  f: {corners: [a, b, c, d], surface: tube}
boundaries:
  rim: {type: BCWall, sides: [ab, bc, dc, a-d]}
)";
    CHECK(named(resolved(text).edges, "ab").length == Approx(5.5).epsilon(1e-12));
}

TEST_CASE("an edge that ends in a pole takes the longitude of its other end") {
    const std::string text = R"(
surfaces:
  ball: {sphere: {center: [0, 0], radius: 1}}
vertices:
  a: {surface: ball, at: [1, 0]}
  b: {surface: ball, at: [2, 0]}
  c: {surface: ball, at: [2, 1]}
  p: [0, 0, 1]
edges:
  ab: {from: a, to: b, surface: ball, cells: 4}
  bc: {from: b, to: c, surface: ball, cells: 4}
  ap: {from: a, to: p, surface: ball}
  pc: {from: p, to: c, surface: ball}
faces:
  f: {corners: [a, b, c, p], surface: ball}
boundaries:
  rim: {type: BCWall, sides: [ab, bc, ap, pc]}
)";
    const Topology t = resolved(text);
    CHECK(named(t.edges, "ap").length == Approx(pi / 2).epsilon(1e-12));
    CHECK(named(t.edges, "pc").length == Approx(pi / 2 - 1).epsilon(1e-12));
}

TEST_CASE("a face over surfaces of which one is unknown is told with the nearest name") {
    CHECK(first_error(on_ball(near_corners, edges_on_halves, "[right, lefd]")) ==
          "20: error: unknown surface 'lefd'\n  hint: did you mean 'left'?\n");
    CHECK(first_error(on_ball(near_corners, edges_on_halves, "[right, right]")) ==
          "20: error: 'surface' names 'right' twice\n  hint: name it once\n");
    CHECK(first_error(on_ball(near_corners, edges_on_halves, "[]")) ==
          "20: error: 'surface' names nothing\n"
          "  hint: as in 'surface: wing' (that it lies on; of several every point is on the "
          "nearest, first the first)\n");
}

TEST_CASE(
    "an edge off all surfaces of its face is told how far and where, unless that is allowed") {
    const std::string straight = R"(  ab: {from: a, to: b, cells: 4}
  bc: {from: b, to: c, surface: right, cells: 4}
  cd: {from: d, to: c, surface: [right, left]}
  da: {from: a, to: d, surface: left}
)";
    CHECK(first_error(on_ball(near_corners, straight, "[right, left]")) ==
          "20: error: edge 'ab' is not on any of the surfaces 'right' and 'left': it is 0.142507 "
          "away "
          "at [0.857493, 0]\n"
          "  14: the edge stands here\n"
          "  hint: the nearest point of 'left' is [1, 0], at u = 0, v = 0\n");
    CHECK(first_error(on_ball(near_corners, straight, "[right, left], gap: 0.2")).empty());
    CHECK(
        first_error(on_ball(near_corners, straight, "minimal, gap: 0.2")) ==
        "20: error: 'gap' is for faces on surfaces\n  hint: name the 'surface', or remove 'gap'\n");
}

TEST_CASE("a vertex off the surface of an edge is told how far") {
    const std::string off = R"(  a: [0.8, -0.6, 0.1]
  b: {surface: [right, left], near: [1, 0.6, 0]}
  c: {surface: [right, left], near: [1, 0.6, 0.5]}
  d: {surface: [right, left], near: [1, -0.6, 0.5]}
)";
    CHECK(first_error(on_ball(off, edges_on_halves, "[right, left]"))
              .find("14: error: vertex 'a' is not on the curve 'chord' as put onto surfaces "
                    "'right' and "
                    "'left': it is 0.1") == 0);
    std::string straight = edges_on_halves;
    straight.replace(straight.find(", along: chord"), 14, "");
    CHECK(first_error(on_ball(off, straight, "[right, left]"))
              .find("14: error: vertex 'a' is on none of the surfaces 'right' and 'left': it is "
                    "0.00498756 away") == 0);
    straight.replace(straight.find("[right, left]"), 13, "ball");
    CHECK(first_error(on_ball(off, straight, "[right, left]"))
              .find("14: error: vertex 'a' is not on the surface 'ball': it is 0.00498756 away") ==
          0);
}

TEST_CASE("parameters off a surface are told with its range") {
    const std::string beyond = R"(  a: {surface: right, at: [4, 0]}
  b: {surface: ball, at: [7, 2]}
  c: {surface: ball, near: [1, 0.6, 0.5]}
  d: {surface: ball, near: [1, -0.6, 0.5]}
)";
    const std::string all = faults(on_ball(beyond, edges_on_halves, "[right, left]"));
    CHECK(
        all.find(
            "9: error: u = 4 is not on surface 'right'\n  hint: its u runs from 0 to 3.14159\n") !=
        std::string::npos);
    CHECK(all.find("10: error: v = 2 is not on surface 'ball'\n  hint: its v runs from -1.5708 to "
                   "1.5708\n") != std::string::npos);
}
