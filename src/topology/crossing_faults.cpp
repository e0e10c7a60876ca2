// SPDX-License-Identifier: Apache-2.0
#include "topology/crossing_faults.h"

#include <fmt/format.h>

#include <cstddef>

#include "topology/text.h"

namespace hexweave {

namespace {

const EdgeEntry* entry_of(const Network& network, int edge) {
    return network.edge_entries[static_cast<std::size_t>(edge)];
}

double straight_length(const Network& network, const Edge& edge) {
    const auto position = [&](int vertex) {
        return network.topology.vertices[static_cast<std::size_t>(vertex)].position;
    };
    return distance(position(edge.start), position(edge.end));
}

/// How often as long as the straight line an edge is; 1 for one that nobody drew or that is closed.
double detour(const Network& network, int edge) {
    const Edge& e = network.edge(edge);
    if (entry_of(network, edge) == nullptr || e.start == e.end) return 1;
    return e.length / straight_length(network, e);
}

bool takes_long_way(const Network& network, int edge) {
    constexpr double half_circle = 1.58;
    return entry_of(network, edge) != nullptr && entry_of(network, edge)->through &&
           detour(network, edge) > half_circle;
}

std::string long_way(const Network& network, int edge) {
    const bool through = entry_of(network, edge)->through.has_value();
    return fmt::format("edge {} takes a way {:.2g} times as long as the straight one: see its '{}'",
                       quoted(network.edge(edge).name), detour(network, edge),
                       through ? "through" : "along");
}

std::string edge_hint(const Network& network, const EdgeCrossing& crossing) {
    for (const int edge : {crossing.first, crossing.second}) {
        if (takes_long_way(network, edge)) return long_way(network, edge);
    }
    return crossing.first == crossing.second
               ? "draw it so that it does not"
               : "the sides of a face meet in its corners alone: move one of the two";
}

}  // namespace

void tell_crossing(CrossingFaults& faults, const Face& face, const EdgeCrossing& crossing,
                   const std::string& order) {
    if (!faults.told.insert({crossing.first, crossing.second}).second) return;
    const Network& network = faults.network;
    const std::string& first = network.edge(crossing.first).name;
    const std::string& second = network.edge(crossing.second).name;
    const std::string what =
        crossing.first == crossing.second
            ? fmt::format("edge {} of face {} crosses itself", quoted(first), quoted(face.name))
            : fmt::format("edges {} and {} of face {} cross", quoted(first), quoted(second),
                          quoted(face.name));
    Diagnostic& error =
        faults.diagnostics.error(face.place,
                                 fmt::format("{} at {}: no grid can lie between its sides", what,
                                             point_text(crossing.place)),
                                 order.empty() ? edge_hint(network, crossing) : order);
    for (const int edge : std::set<int>{crossing.first, crossing.second}) {
        if (entry_of(network, edge) == nullptr) continue;
        error.notes.push_back({network.edge(edge).place,
                               fmt::format("{} is drawn here", quoted(network.edge(edge).name))});
    }
}

std::string corners_in_order(const Network& network, const std::set<int>& edges) {
    constexpr double winding = 1.3;
    int longest = -1;
    double most = winding;
    for (const int edge : edges) {
        const double own = detour(network, edge);
        if (own <= most) continue;
        longest = edge;
        most = own;
    }
    return "its corners are in order, but " +
           (longest < 0 ? "its curved sides lead round it the other way: see 'along' and 'through' "
                          "of its edges"
                        : long_way(network, longest));
}

}  // namespace hexweave
