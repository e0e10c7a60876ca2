// SPDX-License-Identifier: Apache-2.0
// The first cells at the sides of a face or block against those asked there: where heights are
// held, and at walls where they are not.
#pragma once

#include <cstddef>
#include <vector>

#include "core/multiblock.h"
#include "edges/edge_grid.h"
#include "faces/held_side.h"
#include "quality/report.h"
#include "topology/topology.h"

namespace hexweave {

/// Where walls are, and which edges ask for cells at them.
struct AskingWalls {
    const Topology& topology;
    const std::vector<EdgeGrid>& edges;
    const MultiblockGrid& grid;  ///< whose first zones are the topology's faces (blocks in 3D)
};

/// Of zone `zone`, whose points before any sweep are these: an entry for every side of `held`, and
/// one for every other side with walls on it, where an edge that leaves a corner of the side asks
/// for a first cell: heights are asked of the wall between the corners as for a side that is held
/// (see asked_heights). No walls: of the held sides alone.
std::vector<HeightMeasure> first_heights(const AskingWalls* walls, std::size_t zone,
                                         const PointField& points,
                                         const std::vector<HeldSide>& held);

}  // namespace hexweave
