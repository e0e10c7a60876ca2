// SPDX-License-Identifier: Apache-2.0
// What `--explain` follows from edge to edge: which are parallel, and what the file says of each.
#pragma once

#include <string>
#include <vector>

#include "topology/explain.h"
#include "topology/parallel_edges.h"

namespace hexweave {

struct Chains {
    const Topology& topology;
    ParallelEdges parallels;
    std::vector<int> groups;                ///< as topology.edges, of edges of one count
    std::vector<const EdgeEntry*> entries;  ///< as topology.edges; null for a made edge

    const Edge& edge(int index) const { return topology.edges[static_cast<std::size_t>(index)]; }
    const EdgeEntry* entry(int index) const { return entries[static_cast<std::size_t>(index)]; }
    int group(int index) const { return groups[static_cast<std::size_t>(index)]; }
    std::string name(int index) const;  ///< quoted
};

Chains chains_of(const Case& written, const Topology& topology);

/// A step for each crossing on the way from an edge: `what` of the one is that of the other.
void add_crossings(const Chains& chains, int from, const std::vector<Crossing>& crossings,
                   const std::string& what, std::vector<ExplanationStep>& steps);

}  // namespace hexweave
