// SPDX-License-Identifier: Apache-2.0
// The Poisson grid system as a linear operator with coefficients frozen at a given grid: 9 points
// on a face, 19 in a block, made of 5 or 9 numbers per node. It knows nothing of iteration.
#pragma once

#include <array>
#include <vector>

#include "bench/yardsticks/node_lattice.h"

namespace hexweave::bench {

/// The coefficients at one node, index spacing 1, scaled so that the centre of the stencil is -1:
///   second[d] (v+ - 2 v + v-)  along each axis d,
///   mixed[m] (v++ - v+- - v-+ + v--)  in the planes (i, j), (i, k), (j, k),
///   first[d] (v+ - v-)  along each axis d.
/// On a face second[2], mixed[1], mixed[2] and first[2] are zero and never used.
struct Stencil {
    std::array<double, 3> second{};
    std::array<double, 3> mixed{};
    std::array<double, 3> first{};
};

/// Along which two axes mixed[m] differs.
inline constexpr std::array<std::array<std::size_t, 2>, 3> mixed_axes{{{0, 1}, {0, 2}, {1, 2}}};

/// One stencil per node; those of boundary nodes are zero.
using Stencils = std::vector<Stencil>;

/// The coefficients alpha^ij from `points` by central differences [Spekreijse & Boerstoel 1996,
/// eqs. (42), (87)], and the first-order ones as -T^-1 (alpha^ij s_ij) with the very differences
/// that act on the points: the control functions (19), (83) are never formed, and points that are
/// linear in the parameters solve the discrete equations exactly. Where the points have collapsed
/// so far that every alpha^ij is zero, the stencil is that of a uniform orthogonal grid.
void assemble_stencils(const NodeLattice& lattice, const Nodes& points, const Nodes& parameters,
                       Stencils& stencils);

/// result = operator applied to `field` at interior nodes; boundary nodes of result are untouched.
void apply_stencils(const NodeLattice& lattice, const Stencils& stencils, const Nodes& field,
                    Nodes& result);

}  // namespace hexweave::bench
