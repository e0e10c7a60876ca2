// SPDX-License-Identifier: Apache-2.0
// What is known of a grid before it is made: its size, and the counts that are not as written.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "topology/topology.h"

namespace hexweave {

struct PlannedGrid {
    std::string level;  ///< of a family; empty where there is none
    std::size_t cells = 0;
    std::size_t nodes = 0;
    double memory = 0;                           ///< bytes that a run needs at its peak, about
    int threads = 1;                             ///< on so many threads
    std::vector<AdjustedCount> adjusted_counts;  ///< raised above what the level asks for
};

/// With as many threads as a run has now. `solved` is what a run holds: the topology itself, or
/// that of the finest level of a nested family.
PlannedGrid planned_grid(const Topology& topology, const Topology& solved);

}  // namespace hexweave
