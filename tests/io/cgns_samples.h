// SPDX-License-Identifier: Apache-2.0
// Small grids that exercise everything a CGNS file of ours can hold. Zones, families and the
// patches of a zone are in the order of their names, as readers return them.
#pragma once

#include "core/multiblock.h"

namespace hexweave {

/// Two zones "a" and "b" side by side, `b` turned by `b_to_lattice` (a rotation): extents
/// (3, 4, 5) in a common lattice, (4, 3) in two dimensions. One interface, all other sides bounded.
MultiblockGrid joined_pair(int cell_dimension, int physical_dimension,
                           const Orientation& b_to_lattice);

/// A planar C-grid in one zone whose two wakes are joined: a cut. Families of every kind.
MultiblockGrid c_grid();

/// A row of `count` zones of `nodes` nodes along each axis, joined one to the next.
MultiblockGrid row_of_zones(int count, int nodes);

/// All 24 rotations in three dimensions, 4 in two.
std::vector<Orientation> rotations(int cell_dimension);

}  // namespace hexweave
