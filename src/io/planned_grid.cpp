// SPDX-License-Identifier: Apache-2.0
#include "io/planned_grid.h"

#include "core/parallel.h"
#include "topology/limits.h"

namespace hexweave {

PlannedGrid planned_grid(const Topology& topology) {
    PlannedGrid planned{topology.cells(), 0, estimated_bytes(topology, threads()), threads(),
                        topology.adjusted_counts};
    for (const Block& block : topology.blocks) planned.nodes += block.extent.nodes();
    if (topology.is_3d()) return planned;
    for (const Face& face : topology.faces) planned.nodes += face.extent().nodes();
    return planned;
}

}  // namespace hexweave
