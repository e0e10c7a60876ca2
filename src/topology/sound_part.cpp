// SPDX-License-Identifier: Apache-2.0
// From the draft to the network: what is unused is warned of, what is faulty is left out.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "topology/draft.h"

namespace hexweave {

namespace {

/// The edge that another edge's spacing is like, where it names one.
std::optional<int> like_target(const Draft& draft, const DraftEdge& edge) {
    if (edge.entry == nullptr || !edge.entry->spacing) return std::nullopt;
    const auto* like = std::get_if<LikeLaw>(&edge.entry->spacing->value);
    if (like == nullptr) return std::nullopt;
    const std::optional<NamedEdge> target = find_edge(draft.edge_names, like->edge.value);
    if (!target) return std::nullopt;
    return target->edge;
}

struct Kept {
    std::vector<bool> vertices;
    std::vector<bool> edges;
    std::vector<bool> faces;
    std::vector<bool> blocks;
};

/// Keeps an edge, and those that its spacing is taken from.
void keep_edge(const Draft& draft, int index, Kept& kept) {
    std::optional<int> next = index;
    while (next && !kept.edges[static_cast<std::size_t>(*next)]) {
        const auto n = static_cast<std::size_t>(*next);
        const DraftEdge& edge = draft.edges[n];
        if (!edge.sound) return;
        kept.edges[n] = true;
        kept.vertices[static_cast<std::size_t>(edge.edge.start)] = true;
        kept.vertices[static_cast<std::size_t>(edge.edge.end)] = true;
        next = like_target(draft, edge);
    }
}

Kept what_is_kept(const Draft& draft) {
    Kept kept{std::vector<bool>(draft.vertices.size()), std::vector<bool>(draft.edges.size()),
              std::vector<bool>(draft.faces.size()), std::vector<bool>(draft.blocks.size())};
    if (draft.three_dimensional()) {
        for (std::size_t b = 0; b < draft.blocks.size(); ++b) {
            kept.blocks[b] = draft.blocks[b].sound;
            if (!kept.blocks[b]) continue;
            for (const BlockSide& side : draft.blocks[b].block.sides) {
                for (const FaceUse& use : side.faces) {
                    kept.faces[static_cast<std::size_t>(use.face)] = true;
                }
            }
        }
    } else {
        for (std::size_t f = 0; f < draft.faces.size(); ++f) kept.faces[f] = draft.faces[f].sound;
    }
    for (std::size_t f = 0; f < draft.faces.size(); ++f) {
        if (!kept.faces[f]) continue;
        for (const auto& side : draft.faces[f].face.sides) {
            for (const EdgeUse& use : side) keep_edge(draft, use.edge, kept);
        }
    }
    return kept;
}

/// New indices for what is kept; the others get `otherwise`.
std::vector<int> new_indices(const std::vector<bool>& kept, int otherwise) {
    std::vector<int> indices;
    indices.reserve(kept.size());
    int next = 0;
    for (const bool keep : kept) indices.push_back(keep ? next++ : otherwise);
    return indices;
}

bool all_sound(const Draft& draft) {
    const auto sound = [](const auto& entity) { return entity.sound; };
    return std::all_of(draft.vertices.begin(), draft.vertices.end(), sound) &&
           std::all_of(draft.edges.begin(), draft.edges.end(), sound) &&
           std::all_of(draft.faces.begin(), draft.faces.end(), sound) &&
           std::all_of(draft.blocks.begin(), draft.blocks.end(), sound);
}

void renumber(int& index, const std::vector<int>& indices) {
    index = indices[static_cast<std::size_t>(index)];
}

void warn_of_shapes(Draft& draft) {
    for (std::size_t n = 0; n < draft.c.curves.size(); ++n) {
        const Name& name = draft.c.curves[n].name;
        if (draft.curve_used[n] || draft.curve_names.unknown_asked()) continue;
        draft.diagnostics.warning(name.place,
                                  fmt::format("curve {} is not used", quoted(name.value)));
    }
    for (std::size_t n = 0; n < draft.c.surfaces.size(); ++n) {
        const Name& name = draft.c.surfaces[n].name;
        if (draft.surface_used[n] || draft.surface_names.unknown_asked()) continue;
        draft.diagnostics.warning(name.place,
                                  fmt::format("surface {} is not used", quoted(name.value)));
    }
}

}  // namespace

void warn_unused(Draft& draft) {
    if (draft.uses_lost) return;
    for (const DraftEdge& edge : draft.edges) {
        const std::optional<int> target = like_target(draft, edge);
        if (target) draft.edge(*target).used = true;
    }
    warn_of_shapes(draft);
    for (const DraftVertex& v : draft.vertices) {
        if (v.used || draft.vertex_names.unknown_asked()) continue;
        draft.diagnostics.warning(v.vertex.place,
                                  fmt::format("vertex {} is not used", quoted(v.vertex.name)));
    }
    for (const DraftEdge& e : draft.edges) {
        if (e.used || !e.sound || draft.edge_names.unknown_asked()) continue;
        draft.diagnostics.warning(
            e.edge.place, fmt::format("edge {} is not a side of any face", quoted(e.edge.name)));
    }
    if (!draft.three_dimensional()) return;
    for (const DraftFace& f : draft.faces) {
        if (f.used || !f.sound || draft.face_names.unknown_asked()) continue;
        draft.diagnostics.warning(
            f.face.place, fmt::format("face {} is not a side of any block", quoted(f.face.name)));
    }
}

Network sound_part(Draft& draft) {
    const Kept kept = what_is_kept(draft);
    Network network;
    network.intact =
        all_sound(draft) && draft.c.lost_sections.empty() && draft.c.lost_scopes.empty();
    network.three_dimensional = draft.three_dimensional();
    const int otherwise = network.intact ? dropped_unused : dropped_faulty;
    const std::vector<int> vertices = new_indices(kept.vertices, otherwise);
    const std::vector<int> edges = new_indices(kept.edges, otherwise);
    const std::vector<int> faces = new_indices(kept.faces, otherwise);

    Topology& t = network.topology;
    for (std::size_t n = 0; n < kept.vertices.size(); ++n) {
        if (kept.vertices[n]) t.vertices.push_back(draft.vertices[n].vertex);
    }
    for (std::size_t n = 0; n < kept.edges.size(); ++n) {
        if (!kept.edges[n]) continue;
        Edge edge = draft.edges[n].edge;
        renumber(edge.start, vertices);
        renumber(edge.end, vertices);
        t.edges.push_back(std::move(edge));
        network.edge_entries.push_back(draft.edges[n].entry);
    }
    for (std::size_t n = 0; n < kept.faces.size(); ++n) {
        if (!kept.faces[n]) continue;
        Face face = draft.faces[n].face;
        for (int& corner : face.corners) renumber(corner, vertices);
        for (auto& side : face.sides) {
            for (EdgeUse& use : side) renumber(use.edge, edges);
        }
        t.faces.push_back(std::move(face));
        network.face_entries.push_back(draft.faces[n].entry);
    }
    for (std::size_t n = 0; n < kept.blocks.size(); ++n) {
        if (!kept.blocks[n]) continue;
        Block block = draft.blocks[n].block;
        for (int& corner : block.corners) renumber(corner, vertices);
        for (BlockSide& side : block.sides) {
            for (FaceUse& use : side.faces) renumber(use.face, faces);
        }
        t.blocks.push_back(std::move(block));
        network.block_entries.push_back(draft.blocks[n].entry);
    }
    t.put_on_surface = draft.put_on_surface;
    network.edge_names = draft.edge_names;
    network.edge_names.renumber(edges);
    network.face_names = draft.face_names;
    network.face_names.renumber(faces);
    return network;
}

}  // namespace hexweave
