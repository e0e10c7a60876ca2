// SPDX-License-Identifier: Apache-2.0
#include "topology/parallel_edges.h"

#include <algorithm>
#include <cstddef>
#include <deque>

namespace hexweave {

namespace {

constexpr int unvisited = -1;

}  // namespace

ParallelEdges parallel_edges(const Topology& topology) {
    ParallelEdges parallels(topology.edges.size());
    for (std::size_t f = 0; f < topology.faces.size(); ++f) {
        const Face& face = topology.faces[f];
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto& a = face.sides[2 * axis];
            const auto& b = face.sides[2 * axis + 1];
            if (a.size() != 1 || b.size() != 1 || a.front().edge == b.front().edge) continue;
            const bool reversed = a.front().reversed != b.front().reversed;
            const int index = static_cast<int>(f);
            parallels[static_cast<std::size_t>(a.front().edge)].push_back(
                {index, b.front().edge, reversed});
            parallels[static_cast<std::size_t>(b.front().edge)].push_back(
                {index, a.front().edge, reversed});
        }
    }
    return parallels;
}

std::vector<int> parallel_groups(const ParallelEdges& parallels) {
    std::vector<int> groups(parallels.size(), unvisited);
    int next = 0;
    for (std::size_t first = 0; first < parallels.size(); ++first) {
        if (groups[first] != unvisited) continue;
        groups[first] = next;
        std::vector<std::size_t> open{first};
        while (!open.empty()) {
            const std::size_t edge = open.back();
            open.pop_back();
            for (const Crossing& crossing : parallels[edge]) {
                const auto other = static_cast<std::size_t>(crossing.edge);
                if (groups[other] != unvisited) continue;
                groups[other] = next;
                open.push_back(other);
            }
        }
        ++next;
    }
    return groups;
}

std::optional<std::vector<Crossing>> shortest_chain(const ParallelEdges& parallels, int from,
                                                    const std::vector<bool>& targets) {
    std::vector<int> reached_from(parallels.size(), unvisited);
    std::vector<Crossing> reached_by(parallels.size());
    reached_from[static_cast<std::size_t>(from)] = from;
    std::deque<int> open{from};
    while (!open.empty()) {
        int edge = open.front();
        open.pop_front();
        if (targets[static_cast<std::size_t>(edge)]) {
            std::vector<Crossing> chain;
            while (edge != from) {
                chain.push_back(reached_by[static_cast<std::size_t>(edge)]);
                edge = reached_from[static_cast<std::size_t>(edge)];
            }
            std::reverse(chain.begin(), chain.end());
            return chain;
        }
        for (const Crossing& crossing : parallels[static_cast<std::size_t>(edge)]) {
            const auto other = static_cast<std::size_t>(crossing.edge);
            if (reached_from[other] != unvisited) continue;
            reached_from[other] = edge;
            reached_by[other] = crossing;
            open.push_back(crossing.edge);
        }
    }
    return std::nullopt;
}

}  // namespace hexweave
