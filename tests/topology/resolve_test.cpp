// SPDX-License-Identifier: Apache-2.0
// Whole cases: what they resolve to.
#include "topology/resolve.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "topology/resolve_helpers.h"

using namespace hexweave;

namespace {

const double pi = std::acos(-1.0);

const std::string naca = R"(
parameters:
  far: 20
  wall: 1e-3
curves:
  upper:  {naca: "0012", chord: 1, side: upper}
  lower:  {naca: "0012", chord: 1, side: lower}
  circle: {circle: {center: [0.5, 0], radius: far}}
vertices:
  te:     [1, 0]
  le:     [0, 0]
  far_te: [far + 0.5, 0]
  far_le: [0.5 - far, 0]
edges:
  suction:  {from: le, to: te, along: upper, cells: 96, spacing: {start: 5e-3, end: 2e-2}}
  pressure: {from: te, to: le, along: lower, cells: 96, spacing: {like: suction}}
  wake:     {from: te, to: far_te, cells: 64, spacing: {start: wall}}
  nose:     {from: le, to: far_le, spacing: {start: wall}}
  out_up:   {from: far_le, to: far_te, along: circle, through: [0.5, far]}
  out_low:  {from: far_te, to: far_le, along: circle, through: [0.5, -far]}
faces:
  above: {imin: nose, imax: wake, jmin: suction,  jmax: out_up}
  below: {imin: wake, imax: nose, jmin: pressure, jmax: out_low}
boundaries:
  airfoil:  {type: BCWallViscous, sides: [suction, pressure]}
  farfield: {type: BCFarfield, sides: [out_up, out_low]}
)";

const std::string round_pipe = R"(
parameters: {r: 1, q: 0.5, l: 3}
curves:
  circle0: {circle: {center: [0, 0, 0], radius: r}}
  circle1: {circle: {center: [0, 0, l], radius: 2 * r}}
vertices:
  a0: {curve: circle0, at: 0.125}
  b0: {curve: circle0, at: 0.375}
  c0: {curve: circle0, at: 0.625}
  d0: {curve: circle0, at: 0.875}
  a1: {curve: circle1, at: 0.125}
  b1: {curve: circle1, at: 0.375}
  c1: {curve: circle1, at: 0.625}
  d1: {curve: circle1, at: 0.875}
  p0: [q, q]
  q0: [-q, q]
  r0: [-q, -q]
  s0: [q, -q]
  p1: [q, q, l]
  q1: [-q, q, l]
  r1: [-q, -q, l]
  s1: [q, -q, l]
edges:
  north0: {from: a0, to: b0, along: circle0, through: [0, r], cells: 8}
  west0:  {from: b0, to: c0, along: circle0, through: [-r, 0], cells: 9}
  south0: {from: c0, to: d0, along: circle0, through: [0, -r]}
  east0:  {from: d0, to: a0, along: circle0, through: [r, 0]}
  north1: {from: a1, to: b1, along: circle1, through: [0, r, l]}
  west1:  {from: b1, to: c1, along: circle1, through: [-r, 0, l]}
  south1: {from: c1, to: d1, along: circle1, through: [0, -r, l]}
  east1:  {from: d1, to: a1, along: circle1, through: [r, 0, l]}
  spoke:  {from: a0, to: p0, cells: 5, spacing: {start: 1e-2}}
  length: {from: a0, to: a1, cells: 12}
blocks:
  core:  {corners: [r0, s0, p0, q0, r1, s1, p1, q1]}
  north: {corners: [q0, p0, a0, b0, q1, p1, a1, b1]}
  west:  {corners: [r0, q0, b0, c0, r1, q1, b1, c1]}
  south: {corners: [s0, r0, c0, d0, s1, r1, c1, d1]}
  east:  {corners: [p0, s0, d0, a0, p1, s1, d1, a1]}
boundaries:
  wall:    {type: BCWallViscous, sides: [a0-b0-b1-a1, b0-c0-c1-b1, c0-d0-d1-c1, d0-a0-a1-d1]}
  inflow:  {type: BCInflow, sides: [p0-q0-r0-s0, q0-p0-a0-b0, r0-q0-b0-c0, s0-r0-c0-d0, p0-s0-d0-a0]}
  outflow: {type: BCOutflow, sides: [p1-q1-r1-s1, q1-p1-a1-b1, r1-q1-b1-c1, s1-r1-c1-d1, p1-s1-d1-a1]}
)";

}  // namespace

TEST_CASE("An O-grid of two faces resolves without a word") {
    CHECK(faults(naca) == "");
    const Topology t = resolved(naca);
    CHECK(broken_promise(t) == "");
    CHECK(t.planar);
    CHECK(t.size == Approx(40));
    CHECK(t.cells() == 2UL * 96 * 64);
    const Face& above = named(t.faces, "above");
    CHECK(side_text(t, above.side(Side::imin)) == "nose");
    CHECK(side_text(t, above.side(Side::jmax)) == "out_up");
    CHECK(corner_text(t, above.corners) == "le te far_te far_le");
    const Edge& out_up = named(t.edges, "out_up");
    CHECK(out_up.length == Approx(20 * pi).epsilon(1e-12));
    CHECK(evaluate(*out_up.curve, (out_up.from + out_up.to) / 2).y == Approx(20));
    CHECK(law_text(t, named(t.edges, "pressure")) == "same as -suction");
    CHECK(law_text(t, named(t.edges, "out_up")) == "same as suction");
    CHECK(law_text(t, named(t.edges, "out_low")) == "same as -suction");
    CHECK(named(t.edges, "wake").asked_start == 1e-3);
    CHECK_FALSE(named(t.edges, "wake").asked_end);
    CHECK_FALSE(named(t.edges, "pressure").asked_start);
}

TEST_CASE("An O-grid of one face is cut by an edge that it uses on opposite sides") {
    const std::string text = R"(
curves:
  inner: {circle: {center: [0, 0], radius: 1}}
  outer: {circle: {center: [0, 0], radius: 2}}
vertices: {a: [1, 0], b: [2, 0]}
edges:
  in:   {from: a, to: a, along: inner, cells: 16}
  out:  {from: b, to: b, along: outer}
  seam: {from: a, to: b, cells: 8}
faces:
  ring: {imin: seam, imax: seam, jmin: -in, jmax: -out}
boundaries:
  wall: {type: BCWall, sides: [in]}
  far:  {type: BCFarfield, sides: [out]}
)";
    CHECK(faults(text) == "");
    const Topology t = resolved(text);
    CHECK(broken_promise(t) == "");
    CHECK(corner_text(t, t.faces[0].corners) == "a a b b");
    CHECK(side_text(t, t.faces[0].side(Side::jmin)) == "-in");
    CHECK(named(t.edges, "in").length == Approx(2 * pi).epsilon(1e-12));
    CHECK(t.cells() == 16UL * 8);
}

TEST_CASE("A C-grid of four faces shares the wake, a C-grid of one face composes its side") {
    const std::string shapes = R"(
curves:
  u: {naca: "0012", chord: 1, side: upper}
  l: {naca: "0012", chord: 1, side: lower}
  c: {polyline: [[2, -1], [-1, -1], [-1, 1], [2, 1]]}
vertices: {te: [1, 0], le: [0, 0], out: [2, 0], lo: [2, -1], up: [2, 1], ml: [1, -1], mu: [1, 1], fr: [-1, 0]}
)";
    const std::string four = shapes + R"(
edges:
  wake: {from: te, to: out, cells: 8}
  top:  {from: le, to: te, along: u, cells: 16}
  bot:  {from: te, to: le, along: l, cells: 12}
  nose: {from: le, to: fr, cells: 10}
  fu:   {from: fr, to: mu, along: c}
  fl:   {from: fr, to: ml, along: c}
  wu:   {from: mu, to: up, along: c}
  wl:   {from: ml, to: lo, along: c}
faces:
  above: {imin: nose, imax: te-mu, jmin: top, jmax: fu}
  below: {imin: te-ml, imax: nose, jmin: bot, jmax: fl}
  wake_above: {corners: [te, out, up, mu]}
  wake_below: {corners: [out, te, ml, lo]}
boundaries:
  foil: {type: BCWall, sides: [top, bot]}
  far:  {type: BCFarfield, sides: [fu, fl, wu, wl, out-up, lo-out]}
)";
    CHECK(faults(four) == "");
    const Topology t = resolved(four);
    CHECK(broken_promise(t) == "");
    CHECK(side_text(t, named(t.faces, "below").side(Side::jmax)) == "-fl");
    CHECK(side_text(t, named(t.faces, "below").side(Side::imin)) == "-ml-te");
    CHECK(side_text(t, named(t.faces, "wake_below").side(Side::jmin)) == "-wake");
    CHECK(named(t.edges, "ml-te").made);
    CHECK(named(t.edges, "ml-te").cells == 10);
    CHECK(t.cells() == 10UL * (16 + 12 + 8 + 8));

    const std::string one = shapes + R"(
edges:
  wake: {from: te, to: out, cells: 8}
  top:  {from: le, to: te, along: u, cells: 16}
  bot:  {from: te, to: le, along: l, cells: 12}
  far:  {from: lo, to: up, along: c}
  dn:   {from: out, to: lo, cells: 10}
  upp:  {from: out, to: up}
faces:
  c: {imin: dn, imax: upp, jmin: [wake, bot, top, wake], jmax: far}
boundaries:
  foil:  {type: BCWall, sides: [top, bot]}
  outer: {type: BCFarfield, sides: [far, dn, upp]}
)";
    CHECK(faults(one) == R"(6: warning: vertex 'ml' is not used
6: warning: vertex 'mu' is not used
6: warning: vertex 'fr' is not used
)");
    const Topology c = resolved(one);
    CHECK(broken_promise(c) == "");
    CHECK(side_text(c, c.faces[0].side(Side::jmin)) == "-wake bot top wake");
    CHECK(named(c.edges, "far").cells == 8 + 12 + 16 + 8);
    CHECK(law_text(c, named(c.edges, "far")) == "own");  // sides of several edges pass no law on
}

TEST_CASE("A pipe of five blocks by corners makes the edges and faces that are not drawn") {
    CHECK(faults(round_pipe) == "");
    const Topology t = resolved(round_pipe);
    CHECK(broken_promise(t) == "");
    CHECK_FALSE(t.planar);
    CHECK(t.vertices.size() == 16);
    CHECK(t.edges.size() == 2 * (4 + 4 + 4) + 8);
    CHECK(t.faces.size() == 2 * 5 + 3 * 4);
    CHECK(t.cells() == 12UL * (8 * 9 + 2 * 5 * (8 + 9)));
    const Edge& spoke = named(t.edges, "c1-r1");
    CHECK(spoke.made);
    CHECK(vertex_name(t, spoke.start) == "c1");
    CHECK(law_text(t, spoke) == "same as spoke");
    const Face& wall = named(t.faces, "a0-a1-b1-b0");
    CHECK(wall.made);
    CHECK(wall.solve.method == Method::elliptic);
    CHECK(corner_text(t, wall.corners) == "a0 a1 b1 b0");
    CHECK(t.boundaries.size() == 3);
    CHECK(t.boundaries[0].sides.size() == 4);
}

TEST_CASE("Heights to be held are known at their sides") {
    std::string text = naca;
    text.replace(
        text.find("  below: {"), 10,
        "  below: {heights: {jmin: held, imax: {height: 2 * wall, fade: 1/4, growth: 1.5}}, ");
    const Topology t = resolved(text);
    for (const auto& none : t.faces[0].solve.heights) CHECK_FALSE(none);
    const HeightRequests& heights = t.faces[1].solve.heights;
    REQUIRE(heights[2]);
    CHECK_FALSE(heights[2]->height);
    CHECK(heights[2]->fade == 0.03);
    CHECK(heights[2]->growth == 1.3);
    REQUIRE(heights[1]);
    CHECK(heights[1]->height == 2e-3);
    CHECK(heights[1]->fade == 0.25);
    CHECK(heights[1]->growth == 1.5);
    CHECK_FALSE(heights[0]);
    CHECK_FALSE(heights[3]);
}

TEST_CASE("The exponent at flat edges is 0.7 in blocks and their faces, 1 in grids of faces") {
    const auto exponents = [](const std::string& more) {
        const Topology t = resolved(naca + more);
        return std::array{t.faces[0].solve.flat_edge_exponent, t.faces[1].solve.flat_edge_exponent};
    };
    CHECK(exponents("") == std::array{1.0, 1.0});
    CHECK(exponents("solver: {flat_edge_exponent: far / 40}\n") == std::array{0.5, 0.5});

    const Topology pipe = resolved(round_pipe);
    CHECK(pipe.faces[0].solve.flat_edge_exponent == 0.7);
    CHECK(pipe.blocks[0].solve.flat_edge_exponent == 0.7);
    CHECK(resolved(round_pipe + "solver: {flat_edge_exponent: 1}\n")
              .blocks[0]
              .solve.flat_edge_exponent == 1);
    std::string own = naca;
    own.replace(own.find("  below: {"), 10, "  below: {flat_edge_exponent: 0.6, ");
    CHECK(resolved(own).faces[1].solve.flat_edge_exponent == 0.6);
    CHECK(resolved(own).faces[0].solve.flat_edge_exponent == 1);
}

TEST_CASE("Vertices in one place under two names are told, as what meets there is not joined") {
    const auto halves = [](const std::string& second) {
        return R"(
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [2, 0], f: [2, 1], twin: )" +
               second + R"(}
edges:
  ab: {from: a, to: b, cells: 3}
  ad: {from: a, to: d, cells: 3}
  be: {from: twin, to: e, cells: 3}
  ef: {from: e, to: f, cells: 3}
faces:
  l: {corners: [a, b, c, d]}
  r: {corners: [twin, e, f, c]}
boundaries:
  w: {type: BCWall, sides: [ab, ad, be, c-d, ef, c-f, b-c, c-twin]}
)";
    };
    CHECK(
        faults(halves("[1, 0]")) ==
        R"(2: warning: vertices 'b' and 'twin' lie in the same place: edges and faces that meet there under two names are not joined
  2: 'b' is here
  hint: write 'b' for both, unless a gap without width is meant
)");
    CHECK(faults(halves("[1.00001, 0]")).empty());
}

TEST_CASE("vertices of instances in one place are to be joined by ports") {
    const std::string text = faults(R"(hexweave: 1
components:
  square:
    parameters: {x: 0}
    vertices: {a: [x, 0], b: [x + 1, 0], c: [x + 1, 1], d: [x, 1]}
    edges:
      ab: {from: a, to: b, cells: 3}
      bc: {from: b, to: c, cells: 3}
    faces: {f: {corners: [a, b, c, d]}}
    boundaries: {w: {type: BCWall, sides: [ab, bc, c-d, a-d]}}
instances:
  left: {of: square}
  right: {of: square, set: {x: 1}}
)");
    CHECK(text.find("hint: 'join' an instance here, by the 'ports' of its component, unless a gap "
                    "without width is meant") != std::string::npos);
}
