// SPDX-License-Identifier: Apache-2.0
#include "topology/corners.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace hexweave {

namespace {

std::array<int, 2> ascending(int a, int b) {
    return a < b ? std::array{a, b} : std::array{b, a};
}

/// Who needs an edge between two corners: for messages.
struct Owner {
    std::string kind;  ///< "face" or "block"
    Name name;
    std::string remedy;

    std::string text() const { return kind + " " + quoted(name.value); }
};

/// The vertices of the corners named; none after an error. A corner named twice is one.
template <std::size_t count>
std::optional<std::array<int, count>> corner_vertices(Draft& draft,
                                                      const std::array<Name, count>& names,
                                                      const Owner& owner) {
    std::array<int, count> vertices{};
    bool found = true;
    for (std::size_t n = 0; n < count; ++n) {
        const std::optional<int> index = draft.vertex_names.require(names[n], draft.diagnostics);
        if (!index) {
            found = false;
            continue;
        }
        draft.vertex(*index).used = true;
        auto* const earlier = vertices.begin() + n;
        if (found && std::find(vertices.begin(), earlier, *index) != earlier) {
            draft.diagnostics.error(
                names[n].place,
                fmt::format("{} names the corner {} twice", owner.text(), quoted(names[n].value)),
                fmt::format("to collapse an edge to a vertex draw a pole, '{{at: {}}}', and {}",
                            names[n].value, owner.remedy));
            found = false;
        }
        vertices[n] = *index;
    }
    if (!found) return std::nullopt;
    return vertices;
}

void make_edge(Draft& draft, int a, int b, const Owner& owner) {
    if (draft.vertex_name(b) < draft.vertex_name(a)) std::swap(a, b);
    const DraftVertex& start = draft.vertex(a);
    const DraftVertex& end = draft.vertex(b);
    DraftEdge edge;
    edge.edge.name = made_edge_name(start.vertex.name, end.vertex.name);
    edge.edge.place = owner.name.place;
    edge.edge.start = a;
    edge.edge.end = b;
    edge.edge.made = true;
    if (start.sound && end.sound) {
        if (start.vertex.position == end.vertex.position) {
            draft.diagnostics.error(
                owner.name.place,
                fmt::format("the edge between the corners {} and {} of {} has no length",
                            quoted(start.vertex.name), quoted(end.vertex.name), owner.text()),
                "they are the same place: move one");
        } else {
            make_straight(edge.edge, start.vertex.position, end.vertex.position);
            edge.sound = true;
        }
    }
    const int index = static_cast<int>(draft.edges.size());
    draft.edge_names.add(edge.edge.name, index);
    draft.edges_between[ascending(a, b)].edges.push_back(index);
    draft.edges.push_back(std::move(edge));
}

/// Finds or makes the edge between two corners; false after an error.
bool ensure_edge(Draft& draft, int a, int b, const Owner& owner) {
    EdgesBetween& between = draft.edges_between[ascending(a, b)];
    if (between.edges.empty()) make_edge(draft, a, b, owner);
    for (const int edge : between.edges) draft.edge(edge).used = true;
    if (between.edges.size() == 1) return true;
    if (!between.reported) {
        std::vector<std::string> names;
        for (const int edge : between.edges) names.push_back(draft.edge_name(edge));
        std::sort(names.begin(), names.end());
        draft.diagnostics.error(
            owner.name.place,
            fmt::format("the corners {} and {} of {} have several edges between them: {}",
                        quoted(draft.vertex_name(a)), quoted(draft.vertex_name(b)), owner.text(),
                        listed(names)),
            owner.remedy);
        between.reported = true;
    }
    return false;
}

void enter_drawn_edges(Draft& draft) {
    for (std::size_t n = 0; n < draft.edges.size(); ++n) {
        const Edge& edge = draft.edges[n].edge;
        if (edge.start < 0 || edge.end < 0 || edge.start == edge.end) continue;
        draft.edges_between[ascending(edge.start, edge.end)].edges.push_back(static_cast<int>(n));
        draft.edge_names.note_drawn(
            made_edge_name(draft.vertex_name(edge.start), draft.vertex_name(edge.end)), edge.name);
    }
}

/// How a face given by corners would be written with its sides: which edges there are for each.
std::string as_sides(Draft& draft, const std::array<int, 4>& corners) {
    constexpr std::array<std::array<std::size_t, 2>, 4> ends{{{0, 3}, {1, 2}, {0, 1}, {3, 2}}};
    std::string text;
    for (std::size_t side = 0; side < 4; ++side) {
        const int a = corners[ends[side][0]];
        const int b = corners[ends[side][1]];
        std::vector<std::string> names;
        const auto between = draft.edges_between.find(ascending(a, b));
        if (between != draft.edges_between.end()) {
            for (const int edge : between->second.edges) names.push_back(draft.edge_name(edge));
        }
        std::sort(names.begin(), names.end());
        if (names.empty()) {
            names.push_back(fmt::format("an edge drawn from {} to {}", draft.vertex_name(a),
                                        draft.vertex_name(b)));
        }
        text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", side_name(all_sides[side]),
                            fmt::join(names, " or "));
    }
    return text;
}

void join_corner_face(Draft& draft, DraftFace& face, const std::array<Name, 4>& names) {
    Owner owner{"face", face.entry->name, "give the face by its four sides"};
    const auto corners = corner_vertices(draft, names, owner);
    if (!corners) {
        draft.uses_lost = true;
        return;
    }
    owner.remedy += ": " + as_sides(draft, *corners);
    bool edges_found = true;
    for (std::size_t n = 0; n < 4; ++n) {
        if (!ensure_edge(draft, (*corners)[n], (*corners)[(n + 1) % 4], owner)) edges_found = false;
    }
    if (!edges_found) return;
    face.face.corners = *corners;
    face.face.sides = *sides_between(draft, *corners);
    face.sound = true;
    for (const auto& side : face.face.sides) {
        if (!draft.edge(side.front().edge).sound) face.sound = false;
    }
}

void place_block_corners(Draft& draft, DraftBlock& block, const std::array<Name, 8>& names) {
    const Owner owner{"block", block.entry->name, "give the block by its six faces"};
    const auto corners = corner_vertices(draft, names, owner);
    if (!corners) {
        draft.uses_lost = true;
        return;
    }
    block.block.corners = *corners;
    bool edges_found = true;
    constexpr std::array<std::array<std::size_t, 2>, 12> edges{{{0, 1},
                                                                {1, 2},
                                                                {2, 3},
                                                                {3, 0},
                                                                {4, 5},
                                                                {5, 6},
                                                                {6, 7},
                                                                {7, 4},
                                                                {0, 4},
                                                                {1, 5},
                                                                {2, 6},
                                                                {3, 7}}};
    for (const auto& [a, b] : edges) {
        if (!ensure_edge(draft, (*corners)[a], (*corners)[b], owner)) edges_found = false;
    }
    block.corners_known = edges_found;
    if (!edges_found) draft.uses_lost = true;
}

void put_on_surfaces(Face& face, std::vector<std::shared_ptr<const Surface>> surfaces) {
    if (surfaces.size() == 1) {
        face.surface = std::move(surfaces.front());
    } else {
        face.patches = std::move(surfaces);
    }
}

}  // namespace

std::optional<EdgeUse> edge_between(Draft& draft, int a, int b) {
    const auto found = draft.edges_between.find(ascending(a, b));
    if (found == draft.edges_between.end() || found->second.edges.size() != 1) return std::nullopt;
    const int edge = found->second.edges.front();
    return EdgeUse{edge, draft.edge(edge).edge.start != a};
}

std::optional<FrameSides> sides_between(Draft& draft, const std::array<int, 4>& corners) {
    constexpr std::array<std::array<std::size_t, 2>, 4> ends{{{0, 3}, {1, 2}, {0, 1}, {3, 2}}};
    FrameSides sides;
    for (std::size_t n = 0; n < 4; ++n) {
        const auto use = edge_between(draft, corners[ends[n][0]], corners[ends[n][1]]);
        if (!use) return std::nullopt;
        sides[n] = {*use};
    }
    return sides;
}

SolveRequest solve_request(const Case& c, const MethodEntry& how) {
    // In two dimensions it would trade first heights at the wall for angles.
    const double exponent_unsaid = c.blocks.empty() ? 1.0 : 0.7;
    return {how.method,
            how.tolerance.value_or(c.solver.tolerance),
            c.solver.maximum_cycles,
            c.solver.start_folded,
            how.flat_edge_exponent.value_or(c.solver.flat_edge_exponent.value_or(exponent_unsaid)),
            how.heights,
            how.gates};
}

void place_corners(Draft& draft) {
    enter_drawn_edges(draft);
    for (const FaceEntry& entry : draft.c.faces) {
        draft.face_names.add(entry.name.value, static_cast<int>(draft.faces.size()));
        DraftFace face;
        face.face.name = entry.name.value;
        face.face.place = entry.name.place;
        face.face.solve = solve_request(draft.c, entry.how);
        face.face.orthogonal = entry.orthogonal;
        put_on_surfaces(face.face, use_surfaces(draft, entry.surfaces));
        face.entry = &entry;
        if (const auto* corners = std::get_if<std::array<Name, 4>>(&entry.shape)) {
            join_corner_face(draft, face, *corners);
        }
        draft.faces.push_back(std::move(face));
    }
    for (const BlockEntry& entry : draft.c.blocks) {
        DraftBlock block;
        block.block.name = entry.name.value;
        block.block.place = entry.name.place;
        block.block.solve = solve_request(draft.c, entry.how);
        block.entry = &entry;
        if (const auto* corners = std::get_if<std::array<Name, 8>>(&entry.shape)) {
            place_block_corners(draft, block, *corners);
        }
        draft.blocks.push_back(std::move(block));
    }
}

}  // namespace hexweave
