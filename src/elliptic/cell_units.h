// SPDX-License-Identifier: Apache-2.0
// Displacements of nodes measured in cells: along the contravariant base vectors of the grid, so
// that a move across a thin wall cell counts against its thickness and a move along it against its
// length.
#pragma once

#include <vector>

#include "elliptic/node_lattice.h"

namespace hexweave {

/// The rows by which a displacement d becomes cells along i, j and k: (a^1.d, a^2.d, a^3.d), index
/// spacing 1 [Spekreijse & Boerstoel 1996, eqs. (9), (76)]. On a face a^1 and a^2 lie in the
/// tangent plane, and the third row is the unit normal over the square root of the cell's area.
/// Base vectors nearer to one plane (line) than `least_sine` are taken as if they stood that far
/// apart, so that a folded or collapsed cell does not make every displacement infinite; where they
/// vanish altogether the rows are zero.
struct CellFrame {
    Vec3 row_1;
    Vec3 row_2;
    Vec3 row_3;

    Vec3 cells(const Vec3& d) const { return {dot(row_1, d), dot(row_2, d), dot(row_3, d)}; }
};

CellFrame cell_frame(const NodeLattice& lattice, const Nodes& points, std::size_t offset,
                     double least_sine);

/// The largest displacement of an interior node along an axis, in cells of the grid `points`; NaN
/// or infinite when any of them is.
double largest_displacement(const NodeLattice& lattice, const Nodes& points,
                            const Nodes& displacement);

/// What the rounding of coordinates to double precision is in cells, at the interior node where it
/// is most: moves of this size are no moves.
double rounding_in_cells(const NodeLattice& lattice, const Nodes& points);

}  // namespace hexweave
