// SPDX-License-Identifier: Apache-2.0
// Stage 6: measures of a finished grid. Nothing that a solver said is believed: positivity,
// interfaces and spacings are computed anew from the points.
#pragma once

#include <limits>
#include <vector>

#include "blocks/block_grid.h"
#include "core/multiblock.h"
#include "edges/edge_grid.h"
#include "faces/face_grid.h"
#include "quality/report.h"
#include "topology/topology.h"

namespace hexweave {

/// The cells of one zone. Scaled Jacobian of a corner: the determinant of its three edges over the
/// product of their lengths; of a surface cell: the corner's normal against that of the zone's
/// plane, on a surface in space against the cell's mean normal. A cell is folded when a corner is
/// not above 1e-9, unless the corner lies where two sides of the zone meet at more than 150 degrees
/// and the corner is flat there: such corners are counted apart.
ZoneMeasure measure_zone(const Zone& zone, int physical_dimension);

/// Whether the nodes on the two sides of an interface are the same (images of each other where it
/// is periodic, to the round-off of numbers of this epsilon), and the growth across it.
InterfaceMeasure measure_interface(const MultiblockGrid& grid, const Interface& interface,
                                   double epsilon = std::numeric_limits<double>::epsilon());

/// All measures of a run; `stages` is left empty.
Report measure(const Topology& topology, const std::vector<EdgeGrid>& edges,
               const std::vector<FaceGrid>& faces, const std::vector<BlockGrid>& blocks,
               const MultiblockGrid& grid);

}  // namespace hexweave
