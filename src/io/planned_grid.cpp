// SPDX-License-Identifier: Apache-2.0
#include "io/planned_grid.h"

#include <algorithm>
#include <iterator>

#include "core/parallel.h"
#include "topology/limits.h"

namespace hexweave {
namespace {

std::size_t nodes_of_zones(const Topology& topology) {
    std::size_t nodes = 0;
    for (const Block& block : topology.blocks) nodes += block.extent.nodes();
    if (!topology.is_3d()) {
        for (const Face& face : topology.faces) nodes += topology.zone_extent(face).nodes();
    }
    return topology.mirror ? 2 * nodes : nodes;
}

}  // namespace

PlannedGrid planned_grid(const Topology& topology, const Topology& solved) {
    PlannedGrid planned;
    if (topology.family) planned.level = topology.family->names[topology.family->level];
    planned.cells = topology.cells();
    planned.memory = estimated_bytes(solved, threads());
    planned.threads = threads();
    std::copy_if(topology.adjusted_counts.begin(), topology.adjusted_counts.end(),
                 std::back_inserter(planned.adjusted_counts),
                 [](const AdjustedCount& count) { return count.raised(); });
    planned.nodes = nodes_of_zones(topology);
    return planned;
}

}  // namespace hexweave
