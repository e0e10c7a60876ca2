// SPDX-License-Identifier: Apache-2.0
#include "topology/parallel_edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <deque>

#include "topology/names.h"
#include "topology/periodic_match.h"

namespace hexweave {

namespace {

constexpr int unvisited = -1;

void add_interface(const Topology& topology, int interface, ParallelEdges& parallels) {
    for (const PeriodicPair& pair : topology.periodic[static_cast<std::size_t>(interface)].pairs) {
        for (const EdgeMatch& match : matched_edges(topology, pair)) {
            if (match.from == match.to) continue;
            parallels[static_cast<std::size_t>(match.from)].push_back(
                {-1, match.to, match.reversed, interface});
            parallels[static_cast<std::size_t>(match.to)].push_back(
                {-1, match.from, match.reversed, interface});
        }
    }
}

}  // namespace

std::string text_of(const Topology& topology, const Crossing& crossing) {
    if (crossing.face >= 0) {
        const Face& face = topology.faces[static_cast<std::size_t>(crossing.face)];
        return fmt::format("across face {}", quoted(face.name));
    }
    const auto n = static_cast<std::size_t>(crossing.interface);
    return fmt::format("across the periodic interface {}", quoted(topology.periodic[n].name));
}

Place place_of(const Topology& topology, const Crossing& crossing) {
    return crossing.face >= 0
               ? topology.faces[static_cast<std::size_t>(crossing.face)].place
               : topology.periodic[static_cast<std::size_t>(crossing.interface)].place;
}

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
                {index, b.front().edge, reversed, -1});
            parallels[static_cast<std::size_t>(b.front().edge)].push_back(
                {index, a.front().edge, reversed, -1});
        }
    }
    for (std::size_t n = 0; n < topology.periodic.size(); ++n) {
        add_interface(topology, static_cast<int>(n), parallels);
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
