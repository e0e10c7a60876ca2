// SPDX-License-Identifier: Apache-2.0
// Stage 4: points of faces.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "core/field.h"
#include "edges/edge_grid.h"
#include "elliptic/solve_result.h"
#include "faces/held_side.h"
#include "faces/off_surface.h"
#include "topology/topology.h"

namespace hexweave {

/// The points of one face, extent (ni, nj, 1). Its boundary nodes are those of its edges, to the
/// bit.
struct FaceGrid {
    PointField points;
    SolveResult solve;
    std::vector<HeldSide> heights;          ///< of the sides at which heights are held
    std::optional<OffSurface> off_surface;  ///< of its edges, where it lies on a surface
    std::array<bool, 4> flat_corners{};     ///< where two of its sides meet flat, as Face::corners
};

/// One grid per face of the topology, in its order; independent faces in parallel. `done` is called
/// after each face, from any thread but never from two at once.
std::vector<FaceGrid> make_faces(const Topology& topology, const std::vector<EdgeGrid>& edges,
                                 const std::function<void()>& done = {});

/// Every `stride`-th point along each axis, to the bit, and the heights that this grid is asked
/// for; the solve is that of the whole.
FaceGrid every_nth(const FaceGrid& grid, int stride);

}  // namespace hexweave
