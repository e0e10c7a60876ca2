// SPDX-License-Identifier: Apache-2.0
// Whether a grid reaches what was required of it.
#pragma once

#include <vector>

#include "core/multiblock.h"
#include "faces/face_grid.h"
#include "quality/report.h"
#include "topology/topology.h"

namespace hexweave {

/// A result for every gate of the topology, of its faces and of its blocks. A gate on the whole
/// grid is judged by what `report` has measured; one on a face or block by that one alone. (Walls
/// belong to families, not to blocks: a gate of a block has the walls on its own sides.) A gate for
/// which nothing is there to be measured is not met.
std::vector<GateResult> judge_gates(const Topology& topology, const std::vector<FaceGrid>& faces,
                                    const MultiblockGrid& grid, const Report& report);

}  // namespace hexweave
