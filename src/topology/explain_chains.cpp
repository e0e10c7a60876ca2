// SPDX-License-Identifier: Apache-2.0
#include "topology/explain_chains.h"

#include <fmt/format.h>

#include <algorithm>

#include "topology/names.h"

namespace hexweave {

std::string Chains::name(int index) const {
    return quoted(edge(index).name);
}

Chains chains_of(const Case& written, const Topology& topology) {
    Chains chains{topology, parallel_edges(topology), {}, {}};
    chains.groups = parallel_groups(chains.parallels);
    for (const Edge& edge : topology.edges) {
        const auto found = std::find_if(
            written.edges.begin(), written.edges.end(),
            [&](const EdgeEntry& entry) { return !edge.made && entry.name.value == edge.name; });
        chains.entries.push_back(found == written.edges.end() ? nullptr : &*found);
    }
    return chains;
}

void add_crossings(const Chains& chains, int from, const std::vector<Crossing>& crossings,
                   const std::string& what, std::vector<ExplanationStep>& steps) {
    int edge = from;
    for (const Crossing& crossing : crossings) {
        steps.push_back(
            {place_of(chains.topology, crossing),
             fmt::format("  {}, {} has the {} of {}", text_of(chains.topology, crossing),
                         chains.name(edge), what, chains.name(crossing.edge))});
        edge = crossing.edge;
    }
}

}  // namespace hexweave
