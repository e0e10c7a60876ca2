// SPDX-License-Identifier: Apache-2.0
// The finished grid from its parts: zones from blocks (faces in two dimensions), interfaces from
// the declared sharing, patches from the boundaries.
#pragma once

#include <vector>

#include "blocks/block_grid.h"
#include "core/multiblock.h"
#include "faces/face_grid.h"
#include "topology/topology.h"

namespace hexweave {

/// Zones, interfaces, families and patches. An edge (face) used twice is a one-to-one interface,
/// within one zone too; every other side belongs to exactly one boundary. A side made of several
/// edges (faces) gives one interface or patch for each. Points are copied.
MultiblockGrid assemble(const Topology& topology, const std::vector<FaceGrid>& faces,
                        const std::vector<BlockGrid>& blocks);

}  // namespace hexweave
