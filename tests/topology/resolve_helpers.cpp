// SPDX-License-Identifier: Apache-2.0
#include "topology/resolve_helpers.h"

#include <array>
#include <cstdlib>

namespace hexweave {

namespace {

const Edge& edge_of(const Topology& t, const EdgeUse& use) {
    return t.edges[static_cast<std::size_t>(use.edge)];
}

int first_of(const Topology& t, const EdgeUse& use) {
    return use.reversed ? edge_of(t, use).end : edge_of(t, use).start;
}

int last_of(const Topology& t, const EdgeUse& use) {
    return use.reversed ? edge_of(t, use).start : edge_of(t, use).end;
}

int cells_of(const Topology& t, const std::vector<EdgeUse>& side) {
    int sum = 0;
    for (const EdgeUse& use : side) sum += edge_of(t, use).cells;
    return sum;
}

std::string broken_face(const Topology& t, const Face& f) {
    constexpr std::array<std::array<std::size_t, 2>, 4> ends{{{0, 3}, {1, 2}, {0, 1}, {3, 2}}};
    for (std::size_t s = 0; s < 4; ++s) {
        const std::vector<EdgeUse>& side = f.sides[s];
        if (first_of(t, side.front()) != f.corners[ends[s][0]]) return "start of a side";
        if (last_of(t, side.back()) != f.corners[ends[s][1]]) return "end of a side";
        for (std::size_t n = 1; n < side.size(); ++n) {
            if (last_of(t, side[n - 1]) != first_of(t, side[n])) return "chain of a side";
        }
        if (cells_of(t, side) != (s < 2 ? f.cells_j : f.cells_i)) return "cells of a side";
    }
    return "";
}

/// The vertex of a face at a node of its index space that is a corner.
int vertex_at(const Face& f, const Node& node) {
    const bool i = node[0] > 0;
    const bool j = node[1] > 0;
    return f.corners[j ? (i ? 2 : 3) : (i ? 1 : 0)];
}

std::string broken_block(const Topology& t, const Block& b) {
    for (const Side side : all_sides) {
        const BlockSide& faces = b.side(side);
        const auto axes = tangential_axes(side);
        for (const int u : {0, 1}) {
            for (const int v : {0, 1}) {
                const FaceUse& use = faces.at(u * (faces.columns - 1), v * (faces.rows() - 1));
                const Face& face = t.faces[static_cast<std::size_t>(use.face)];
                const Extent own = own_extent(use.orientation, face.extent());
                if (u == 0 && use.begin[0] != 0) return "begin of a side";
                if (v == 0 && use.begin[1] != 0) return "begin of a side";
                if (u == 1 && use.begin[0] + own.ni != b.extent[axes[0]]) return "end of a side";
                if (v == 1 && use.begin[1] + own.nj != b.extent[axes[1]]) return "end of a side";
                std::array<int, 3> corner{};
                corner[static_cast<std::size_t>(axis_of(side))] = is_max(side) ? 1 : 0;
                corner[static_cast<std::size_t>(axes[0])] = u;
                corner[static_cast<std::size_t>(axes[1])] = v;
                const int position = 4 * corner[2] + (corner[1] == 0 ? corner[0] : 3 - corner[0]);
                const int vertex = b.corners[static_cast<std::size_t>(position)];
                const Node node{u * (own.ni - 1), v * (own.nj - 1), 0};
                const Node on_face = map_node(use.orientation, node, face.extent());
                if (vertex_at(face, on_face) != vertex) return "corner of a side";
            }
        }
    }
    return "";
}

}  // namespace

std::string broken_promise(const Topology& t) {
    for (const Edge& e : t.edges) {
        if (e.cells < 1 || !(e.length > 0 || e.pole)) return e.name + ": cells or length";
        const auto at = [&](int vertex) { return t.vertices[static_cast<std::size_t>(vertex)]; };
        const double near = 1e-6 * t.size;
        if (distance(evaluate(*e.curve, e.from), at(e.start).position) > near) return e.name;
        if (distance(evaluate(*e.curve, e.to), at(e.end).position) > near) return e.name;
        const auto* same = std::get_if<SameAs>(&e.law);
        if (same == nullptr) continue;
        const Edge& other = t.edges[static_cast<std::size_t>(same->edge)];
        if (other.cells != e.cells) return e.name + ": cells of the edge it is the same as";
        if (std::holds_alternative<SameAs>(other.law)) return e.name + ": same as same as";
    }
    for (const Face& f : t.faces) {
        const std::string broken = broken_face(t, f);
        if (!broken.empty()) return f.name + ": " + broken;
    }
    for (const Block& b : t.blocks) {
        const std::string broken = broken_block(t, b);
        if (!broken.empty()) return b.name + ": " + broken;
    }
    return "";
}

}  // namespace hexweave
