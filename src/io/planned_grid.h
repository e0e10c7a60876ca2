// SPDX-License-Identifier: Apache-2.0
// What is known of a grid before it is made: its size, and the counts that are not as written.
#pragma once

#include <cstddef>
#include <vector>

#include "topology/topology.h"

namespace hexweave {

struct PlannedGrid {
    std::size_t cells = 0;
    std::size_t nodes = 0;
    double memory = 0;  ///< bytes that a run needs at its peak, about
    int threads = 1;    ///< on so many threads
    std::vector<AdjustedCount> adjusted_counts;
};

/// With as many threads as a run has now.
PlannedGrid planned_grid(const Topology& topology);

}  // namespace hexweave
