// SPDX-License-Identifier: Apache-2.0
// The boundary of a face from the points of its edges.
#pragma once

#include <vector>

#include "core/field.h"
#include "edges/edge_grid.h"
#include "topology/topology.h"

namespace hexweave {

/// The points of one side in the direction of the face's own axis: those of its edges, one after
/// another, to the bit.
std::vector<Vec3> side_points(const Face& face, Side side, const std::vector<EdgeGrid>& edges);

/// A field of the face's extent with the points of its edges on its boundary.
PointField face_boundary(const Face& face, const std::vector<EdgeGrid>& edges);

}  // namespace hexweave
