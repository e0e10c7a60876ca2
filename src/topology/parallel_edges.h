// SPDX-License-Identifier: Apache-2.0
// Parallel edges: those that stand opposite each other across faces. Cell counts and spacing laws
// pass between them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "topology/topology.h"

namespace hexweave {

/// One step from an edge across a face to the edge on the opposite side, or across a periodic
/// interface to its image or what it is the image of; `reversed` when the two run against each
/// other.
struct Crossing {
    int face = -1;  ///< or -1
    int edge = 0;
    bool reversed = false;
    int interface = -1;  ///< or -1
};

/// "across face 'x'", and the place of that face; or of a periodic interface.
std::string text_of(const Topology& topology, const Crossing& crossing);
Place place_of(const Topology& topology, const Crossing& crossing);

/// For every edge the crossings to its neighbours, across faces that have it alone on one side and
/// another edge alone on the opposite side, and across periodic interfaces.
using ParallelEdges = std::vector<std::vector<Crossing>>;
ParallelEdges parallel_edges(const Topology& topology);

/// For every edge the number of its group: edges joined by crossings are in one group. Groups are
/// numbered by their first edge.
std::vector<int> parallel_groups(const ParallelEdges& parallels);

/// The crossings that lead from one edge to the nearest one among `targets` (a flag for every
/// edge), fewest faces first; empty when the edge itself is one, nothing when none can be reached.
std::optional<std::vector<Crossing>> shortest_chain(const ParallelEdges& parallels, int from,
                                                    const std::vector<bool>& targets);

}  // namespace hexweave
