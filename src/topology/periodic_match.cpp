// SPDX-License-Identifier: Apache-2.0
#include "topology/periodic_match.h"

#include <algorithm>
#include <limits>

#include "topology/face_frame.h"

namespace hexweave {

namespace {

constexpr double about_as_far = 1 - 1e-6;

}  // namespace

std::vector<EdgeMatch> matched_edges(const Topology& topology, const PeriodicPair& pair) {
    if (!topology.is_3d()) return {{pair.from, pair.to, pair.orientation.axes[0] < 0}};
    const Face& from = topology.faces[static_cast<std::size_t>(pair.from)];
    const Face& to = topology.faces[static_cast<std::size_t>(pair.to)];
    const FrameSides seen = sides_in_frame(from.sides, pair.orientation);
    std::vector<EdgeMatch> matches;
    for (std::size_t side = 0; side < 4; ++side) {
        if (seen[side].size() != to.sides[side].size()) return {};
        for (std::size_t n = 0; n < seen[side].size(); ++n) {
            const EdgeUse& image = seen[side][n];
            const EdgeUse& own = to.sides[side][n];
            if (image.pole != own.pole) return {};
            matches.push_back({image.edge, own.edge, image.reversed != own.reversed});
        }
    }
    return matches;
}

const SideMatcher::Samples& SideMatcher::samples(int edge) {
    const auto known = samples_.find(edge);
    if (known != samples_.end()) return known->second;
    const Edge& e = network_.edge(edge);
    const auto vertex = [&](int index) {
        return network_.topology.vertices[static_cast<std::size_t>(index)].position;
    };
    Samples points;
    points.fill(vertex(e.start));
    points.back() = vertex(e.end);
    if (!e.pole) {
        const ArcLengthTable table(*e.curve, e.from, e.to);
        for (std::size_t n = 1; n < intervals; ++n) {
            const double length = table.length() * static_cast<double>(n) / intervals;
            points[n] = evaluate(*e.curve, table.parameter_at(length));
        }
    }
    return samples_.emplace(edge, points).first->second;
}

int SideMatcher::end_at(const Edge& edge, std::size_t sample) {
    return sample == 0 ? edge.start : sample == intervals ? edge.end : -1;
}

SideMatch SideMatcher::compare(const PeriodicPair& pair) {
    SideMatch match;
    match.pair = pair;
    match.distance = std::numeric_limits<double>::infinity();
    for (const EdgeMatch& edge : matched_edges(network_.topology, pair)) {
        for (std::size_t n = 0; n <= intervals; ++n) {
            const std::size_t m = edge.reversed ? intervals - n : n;
            const Vec3 carried = image(map_, samples(edge.from)[n]);
            const Vec3 there = samples(edge.to)[m];
            const double off = distance(carried, there);
            const int vertex_from = end_at(network_.edge(edge.from), n);
            const int vertex_to = end_at(network_.edge(edge.to), m);
            // Of what is about as far off, a vertex says more.
            const double kept = match.distance * (vertex_from >= 0 ? about_as_far : 1);
            if (match.divided_alike && off <= kept) continue;
            match = {pair, true, off, edge, carried, there, vertex_from, vertex_to};
        }
    }
    return match;
}

std::vector<SideMatch> SideMatcher::ways(int from, int to) {
    std::vector<SideMatch> found;
    if (network_.three_dimensional) {
        for (const Orientation& orientation : face_orientations()) {
            found.push_back(compare({from, to, orientation}));
        }
    } else {
        found = {compare({from, to, {}}), compare({from, to, Orientation{{-1, 2, 3}}})};
    }
    std::stable_sort(found.begin(), found.end(), [](const SideMatch& a, const SideMatch& b) {
        return a.distance < b.distance;
    });
    return found;
}

}  // namespace hexweave
