// SPDX-License-Identifier: Apache-2.0
#include "topology/grid_sides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace hexweave {

namespace {

template <class Entities>
void enter(const Entities& entities, GridSides& sides) {
    for (const auto& entity : entities) {
        sides.names.push_back(entity.name);
        sides.places.push_back(entity.place);
    }
    sides.users.resize(entities.size());
}

GridSides faces_of_blocks(const Topology& topology) {
    GridSides sides;
    sides.kind = "face";
    sides.user = "block";
    enter(topology.faces, sides);
    for (const Face& face : topology.faces) {
        sides.collapsed.push_back((face.collapsed[0] ? 1 : 0) + (face.collapsed[1] ? 1 : 0));
    }
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
        sides.names_of_users.push_back(topology.blocks[b].name);
        for (const BlockSide& side : topology.blocks[b].sides) {
            for (const FaceUse& use : side.faces) {
                sides.users[static_cast<std::size_t>(use.face)].push_back(static_cast<int>(b));
            }
        }
    }
    return sides;
}

GridSides edges_of_faces(const Topology& topology) {
    GridSides sides;
    sides.kind = "edge";
    sides.user = "face";
    enter(topology.edges, sides);
    for (const Edge& edge : topology.edges) {
        sides.collapsed.push_back((edge.pole ? 1 : 0) + (edge.on_axis ? 1 : 0));
    }
    for (std::size_t f = 0; f < topology.faces.size(); ++f) {
        sides.names_of_users.push_back(topology.faces[f].name);
        for (const auto& side : topology.faces[f].sides) {
            for (const EdgeUse& use : side) {
                sides.users[static_cast<std::size_t>(use.edge)].push_back(static_cast<int>(f));
            }
        }
    }
    return sides;
}

/// The names of what a side of a block, or of a face, is made of: of "inlet.jmin" the faces; empty
/// where it is no such name.
std::vector<std::string> parts_of_side(const Topology& topology, bool of_blocks,
                                       const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) return {};
    const std::string owner = name.substr(0, dot);
    std::vector<std::string> parts;
    for (const Side side : all_sides) {
        if (side_name(side) != name.substr(dot + 1)) continue;
        for (const Block& block : topology.blocks) {
            if (block.name != owner) continue;
            for (const FaceUse& use : block.side(side).faces) {
                parts.push_back(topology.faces[static_cast<std::size_t>(use.face)].name);
            }
        }
        if (of_blocks || axis_of(side) == 2) continue;
        for (const Face& face : topology.faces) {
            if (face.name != owner) continue;
            for (const EdgeUse& use : face.side(side)) {
                parts.push_back(topology.edges[static_cast<std::size_t>(use.edge)].name);
            }
        }
    }
    return parts;
}

/// The index of the edge or face of a name; nothing after an error.
std::optional<int> find_kind(const Network& network, const GridSides& sides, const Name& name,
                             const SideOwner& owner, Diagnostics& diagnostics) {
    const auto edge = find_edge(network.edge_names, name.value);
    const auto face = find_face(network.face_names, name.value);
    const bool of_faces = network.three_dimensional;
    if (of_faces && face) return face;
    if (!of_faces && edge) return edge->edge;
    if (of_faces ? edge.has_value() : face.has_value()) {
        diagnostics.error(name.place,
                          fmt::format("{} is {}, but the sides of {} are {}s", quoted(name.value),
                                      of_faces ? "an edge" : "a face", owner.one, sides.kind),
                          of_faces
                              ? fmt::format("with blocks, {} are made of faces", owner.many)
                              : fmt::format("without blocks, {} are made of edges", owner.many));
    } else if (const std::vector<std::string> parts =
                   parts_of_side(network.topology, of_faces, name.value);
               !parts.empty()) {
        diagnostics.error(name.place,
                          fmt::format("{} is a side of a {}, but the sides of {} are {}s",
                                      quoted(name.value), sides.user, owner.one, sides.kind),
                          fmt::format("write {}, the {}{} there", fmt::join(parts, ", "),
                                      sides.kind, parts.size() == 1 ? "" : "s"));
    } else if (!name.value.empty() &&
               (network.intact || name.value.find('-') == std::string::npos)) {
        // Where something is at fault, an edge or a face that it would make is not.
        (of_faces ? network.face_names : network.edge_names).tell_unknown(name, diagnostics);
    }
    return std::nullopt;
}

}  // namespace

GridSides grid_sides(const Network& network) {
    return network.three_dimensional ? faces_of_blocks(network.topology)
                                     : edges_of_faces(network.topology);
}

std::string users_text(const GridSides& sides, const std::vector<int>& users) {
    std::vector<std::string> names;
    for (const int user : users) {
        const std::string& name = sides.names_of_users[static_cast<std::size_t>(user)];
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return fmt::format("{}{} {}", sides.user, names.size() == 1 ? "" : "s", listed(names));
}

std::optional<int> find_side(const Network& network, const GridSides& sides, const Name& name,
                             const SideOwner& owner, Diagnostics& diagnostics) {
    const std::optional<int> side = find_kind(network, sides, name, owner, diagnostics);
    if (!side || *side == dropped_faulty) return std::nullopt;
    if (*side >= 0 && !sides.users[static_cast<std::size_t>(*side)].empty()) return side;
    // The face (block) that has it may be the one that is at fault.
    if (!network.intact) return std::nullopt;
    diagnostics.error(
        name.place, fmt::format("{} {} is no side of the grid", sides.kind, quoted(name.value)),
        fmt::format("no {0} has it; make it a side of a {0}, or take it out here", sides.user));
    return std::nullopt;
}

}  // namespace hexweave
