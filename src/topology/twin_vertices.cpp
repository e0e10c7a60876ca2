// SPDX-License-Identifier: Apache-2.0
#include "topology/twin_vertices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "topology/names.h"
#include "topology/sample.h"

namespace hexweave {
namespace {

/// What makes them one: within an instance only its ports can.
std::string remedy(const Vertex& first, const Vertex& second) {
    if (scope_at(first.place) == scope_at(second.place)) {
        return fmt::format("write {} for both", quoted(first.name));
    }
    return "'join' an instance here, by the 'ports' of its component";
}

void warn_of(const Vertex& first, const Vertex& second, Diagnostics& diagnostics) {
    Diagnostic& warning = diagnostics.warning(
        second.place,
        fmt::format("vertices {} and {} lie in the same place: edges and faces that meet there "
                    "under two names are not joined",
                    quoted(first.name), quoted(second.name)),
        remedy(first, second) + ", unless a gap without width is meant");
    warning.notes.push_back({first.place, fmt::format("{} is here", quoted(first.name))});
}

}  // namespace

void warn_of_twin_vertices(const Topology& topology, Diagnostics& diagnostics) {
    std::vector<Vec3> positions;
    std::vector<std::size_t> order;
    for (const Vertex& vertex : topology.vertices) {
        order.push_back(order.size());
        positions.push_back(vertex.position);
    }
    const double reach = 1e-9 * box_around(positions).diagonal();
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return positions[a].x != positions[b].x ? positions[a].x < positions[b].x : a < b;
    });
    for (std::size_t n = 0; n < order.size(); ++n) {
        const Vec3& here = positions[order[n]];
        for (std::size_t m = n + 1; m < order.size(); ++m) {
            const Vec3& there = positions[order[m]];
            if (there.x > here.x + reach) break;
            if (distance(here, there) > reach) continue;
            const auto [first, second] = std::minmax(order[n], order[m]);
            warn_of(topology.vertices[first], topology.vertices[second], diagnostics);
            break;  // of three in one place, two pairs say enough
        }
    }
}

}  // namespace hexweave
