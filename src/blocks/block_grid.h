// SPDX-License-Identifier: Apache-2.0
// Stage 5: points of blocks.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/field.h"
#include "elliptic/solve_result.h"
#include "faces/face_grid.h"
#include "faces/held_side.h"
#include "topology/topology.h"

namespace hexweave {

/// The points of one block. Its boundary nodes are those of its faces, to the bit.
struct BlockGrid {
    PointField points;
    SolveResult solve;
    std::vector<HeldSide> heights;        ///< of the sides at which heights are held
    std::vector<std::string> flat_edges;  ///< edges where two of its sides meet flat
};

/// One grid per block of the topology, in its order; independent blocks in parallel. `done` is
/// called after each block, from any thread but never from two at once.
std::vector<BlockGrid> make_blocks(const Topology& topology, const std::vector<FaceGrid>& faces,
                                   const std::function<void()>& done = {});

/// Every `stride`-th point along each axis, to the bit, as of a face.
BlockGrid every_nth(const BlockGrid& grid, int stride);

}  // namespace hexweave
