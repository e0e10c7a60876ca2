// SPDX-License-Identifier: Apache-2.0
// The boundary of a block from the points of its faces.
#pragma once

#include <vector>

#include "core/field.h"
#include "faces/face_grid.h"
#include "topology/topology.h"

namespace hexweave {

/// The node of a block's side at (a, b) of its two tangential axes.
Node side_node(Side side, int a, int b, const Extent& block);

/// The points of a whole side of a block, over its two tangential axes.
PointField side_points(const Block& block, Side side, const std::vector<FaceGrid>& faces);

/// A field of the block's extent with the points of its six faces on its boundary, to the bit.
PointField block_boundary(const Block& block, const std::vector<FaceGrid>& faces);

}  // namespace hexweave
