// SPDX-License-Identifier: Apache-2.0
#include "topology/resolve.h"

#include <catch2/catch.hpp>

#include "topology/resolve_helpers.h"

using namespace hexweave;

namespace {

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

}  // namespace

TEST_CASE("An O-grid of two faces resolves") {
    REQUIRE(faults(naca) == "");
    const Topology t = resolved(naca);
    CHECK(t.planar);
    CHECK(t.size == Approx(40));
    const Face& above = named(t.faces, "above");
    CHECK(side_text(t, above.side(Side::imin)) == "nose");
    CHECK(side_text(t, above.side(Side::jmax)) == "out_up");
    CHECK(above.cells_i == 96);
    CHECK(above.cells_j == 64);
    const Edge& out_up = named(t.edges, "out_up");
    CHECK(out_up.length == Approx(3.14159265358979 * 20));
    CHECK(out_up.cells == 96);
    CHECK(std::get<SameAs>(named(t.edges, "pressure").law).reversed);
    CHECK(std::get<SameAs>(named(t.edges, "out_low").law).edge == 0);
}
