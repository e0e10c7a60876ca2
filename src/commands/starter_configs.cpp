// SPDX-License-Identifier: Apache-2.0
#include "commands/starter_configs.h"

namespace hexweave {
namespace {

constexpr std::string_view airfoil =
    R"(# An airfoil in a far field: an O-grid of two faces. Change the numbers under `parameters`, then
#   hexweave check NAME.yaml      what it makes of this
#   hexweave graph NAME.yaml -o NAME.svg
#   hexweave run NAME.yaml        writes NAME.cgns
#
#              far
#         .-----------.
#       /    above     \           i runs along the airfoil and the far field,
#   far_le --le  te-- far_te       j from the airfoil outwards
#       \    below     /
#         '-----------'
hexweave: 1
title: NAME, an airfoil
units: m

parameters:
  chord: 1
  far: 15 * chord           # radius of the far field
  wall: 1e-3 * chord        # first cell off the airfoil; for a boundary layer 1e-5 or less
  around: 64                # cells along one side of the airfoil
  normal: 48                # cells from the airfoil to the far field
  mid: chord / 2

curves:                     # shapes; or a file of coordinates: {airfoil: section.dat, side: upper}
  upper: {naca: "2412", chord: chord, side: upper}
  lower: {naca: "2412", chord: chord, side: lower}
  far_away: {circle: {center: [mid, 0], radius: far}}

vertices:
  le: [0, 0]
  te: [chord, 0]
  far_le: [mid - far, 0]
  far_te: [mid + far, 0]

edges:                      # lines with points on them; the cells of opposite sides need be said once
  suction:  {from: le, to: te, along: upper, cells: around, spacing: {start: 2e-3 * chord, end: 4e-3 * chord}}
  pressure: {from: te, to: le, along: lower, cells: around, spacing: {start: 4e-3 * chord, end: 2e-3 * chord}}
  nose:     {from: le, to: far_le, cells: normal, spacing: {start: wall}}
  tail:     {from: te, to: far_te, spacing: {start: wall}}
  far_up:   {from: far_le, to: far_te, along: far_away, through: [mid, far], spacing: uniform}
  far_low:  {from: far_te, to: far_le, along: far_away, through: [mid, -far], spacing: uniform}

faces:                      # four sides; faces that share an edge are joined there
  above: {imin: nose, imax: tail, jmin: suction, jmax: far_up, orthogonal: [jmin]}
  below: {imin: tail, imax: nose, jmin: pressure, jmax: far_low, orthogonal: [jmin]}

boundaries:                 # families of free sides, with CGNS types
  airfoil:  {type: BCWallViscous, sides: [suction, pressure]}
  farfield: {type: BCFarfield, sides: [far_up, far_low]}
)";

constexpr std::string_view channel =
    R"(# A channel over a hump: one face. Change the numbers under `parameters`, then
#   hexweave check NAME.yaml      what it makes of this
#   hexweave graph NAME.yaml -o NAME.svg
#   hexweave run NAME.yaml        writes NAME.cgns
#
#    d ------- top ------- c
#    |                     |       i runs from the inflow to the outflow,
#  inflow    channel    outflow    j from the floor to the top
#    |        __           |
#    a ----- floor ------- b
hexweave: 1
title: NAME, a channel over a hump
units: m

parameters:
  length: 3
  height: 1
  hump: 0.1                 # its height
  wall: 2e-3                # first cell off the floor
  along: 96                 # cells
  across: 32

curves:                     # a formula of t, where t runs over `range`
  ground: {formula: [t, hump * exp(-20 * (t - length / 2)^2)], range: [0, length]}

vertices:
  a: {curve: ground, at: 0} # a place on a curve, by the fraction of its length
  b: {curve: ground, at: 1}
  c: [length, height]
  d: [0, height]

edges:
  floor:  {from: a, to: b, along: ground, cells: along}
  inflow: {from: a, to: d, cells: across, spacing: {start: wall}}

faces:                      # by its corners: the edges that nobody drew are straight, and named b-c, c-d
  channel: {corners: [a, b, c, d]}

boundaries:
  floor:   {type: BCWallViscous, sides: floor}
  top:     {type: BCSymmetryPlane, sides: c-d}
  inflow:  {type: BCInflow, sides: inflow}
  outflow: {type: BCOutflow, sides: b-c}
)";

constexpr std::string_view pipe =
    R"(# A pipe: a block in the core and four around it. Change the numbers under `parameters`, then
#   hexweave check NAME.yaml      what it makes of this
#   hexweave graph NAME.yaml -o NAME.svg
#   hexweave run NAME.yaml        writes NAME.cgns
#
#              p1                      inlet at z = 0 (a, p), outlet at z = length (b, q)
#           .--'--.
#         /    a1   \                  a0..a3  corners of the core
#        p2  a2  a0  p0                p0..p3  points of the wall
#         \    a3   /
#           '--.--'
#              p3
hexweave: 1
title: NAME, a pipe
units: m

parameters:
  radius: 0.5
  length: 2
  wall: 5e-3                # last cell before the wall
  across: 10                # cells along a quarter of the wall
  radial: 12                # cells from the core to the wall
  along: 20                 # cells from the inlet to the outlet
  a: radius / 2
  d: radius * cos(pi / 4)

curves:
  inlet_rim:  {circle: {center: [0, 0, 0], radius: radius}}
  outlet_rim: {circle: {center: [0, 0, length], radius: radius}}

vertices:
  a0: [a, 0, 0]
  a1: [0, a, 0]
  a2: [-a, 0, 0]
  a3: [0, -a, 0]
  p0: [radius, 0, 0]
  p1: [0, radius, 0]
  p2: [-radius, 0, 0]
  p3: [0, -radius, 0]
  b0: [a, 0, length]
  b1: [0, a, length]
  b2: [-a, 0, length]
  b3: [0, -a, length]
  q0: [radius, 0, length]
  q1: [0, radius, length]
  q2: [-radius, 0, length]
  q3: [0, -radius, length]

edges:                      # what is not straight, and where cells are said; the rest is made
  inlet_0:  {from: p0, to: p1, along: inlet_rim, through: [d, d, 0], cells: across}
  inlet_1:  {from: p1, to: p2, along: inlet_rim, through: [-d, d, 0], cells: across}
  inlet_2:  {from: p2, to: p3, along: inlet_rim, through: [-d, -d, 0]}
  inlet_3:  {from: p3, to: p0, along: inlet_rim, through: [d, -d, 0]}
  outlet_0: {from: q0, to: q1, along: outlet_rim, through: [d, d, length]}
  outlet_1: {from: q1, to: q2, along: outlet_rim, through: [-d, d, length]}
  outlet_2: {from: q2, to: q3, along: outlet_rim, through: [-d, -d, length]}
  outlet_3: {from: q3, to: q0, along: outlet_rim, through: [d, -d, length]}
  to_wall:  {from: a0, to: p0, cells: radial, spacing: {end: wall}}
  axial:    {from: p0, to: q0, cells: along}

faces:                      # exact on the wall: arcs divided alike, straight lines between
  wall_0: {corners: [p0, p1, q1, q0], method: algebraic}
  wall_1: {corners: [p1, p2, q2, q1], method: algebraic}
  wall_2: {corners: [p2, p3, q3, q2], method: algebraic}
  wall_3: {corners: [p3, p0, q0, q3], method: algebraic}

blocks:                     # by eight corners: four at the inlet, the four above them
  middle: {corners: [a0, a1, a2, a3, b0, b1, b2, b3]}
  east:   {corners: [a0, p0, p1, a1, b0, q0, q1, b1]}
  north:  {corners: [a1, p1, p2, a2, b1, q1, q2, b2]}
  west:   {corners: [a2, p2, p3, a3, b2, q2, q3, b3]}
  south:  {corners: [a3, p3, p0, a0, b3, q3, q0, b0]}

boundaries:                 # made faces are named after their corners
  wall:   {type: BCWallViscous, sides: [wall_0, wall_1, wall_2, wall_3]}
  inlet:  {type: BCInflow, sides: [a0-a1-a2-a3, a0-p0-p1-a1, a1-p1-p2-a2, a2-p2-p3-a3, a3-p3-p0-a0]}
  outlet: {type: BCOutflow, sides: [b0-b1-b2-b3, b0-q0-q1-b1, b1-q1-q2-b2, b2-q2-q3-b3, b3-q3-q0-b0]}
)";

}  // namespace

const std::array<StarterConfig, 3> starter_configs{
    {{"airfoil", "an O-grid around a NACA section", airfoil},
     {"channel", "a face over a hump", channel},
     {"pipe", "five blocks", pipe}}};

}  // namespace hexweave
