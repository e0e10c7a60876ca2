// SPDX-License-Identifier: Apache-2.0
#include "topology/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <set>

#include "topology/explain_counts.h"
#include "topology/explain_edge.h"
#include "topology/explain_instances.h"
#include "topology/face_frame.h"
#include "topology/names.h"
#include "topology/text.h"

namespace hexweave {

namespace {

constexpr std::array<Side, 4> face_sides{Side::imin, Side::imax, Side::jmin, Side::jmax};

const Vertex& vertex_of(const Topology& topology, int index) {
    return topology.vertices[static_cast<std::size_t>(index)];
}
const Edge& edge_of(const Topology& topology, int index) {
    return topology.edges[static_cast<std::size_t>(index)];
}
const Face& face_of(const Topology& topology, int index) {
    return topology.faces[static_cast<std::size_t>(index)];
}

template <std::size_t Count>
std::string corners_text(const Topology& topology, const std::array<int, Count>& corners) {
    std::string text;
    for (const int corner : corners) {
        text += fmt::format("{}{}", text.empty() ? "" : ", ", vertex_of(topology, corner).name);
    }
    return text;
}

/// "forwards, from 'a' to 'b'": how a side runs through an edge.
std::string run_text(const Topology& topology, const EdgeUse& use) {
    const Edge& edge = edge_of(topology, use.edge);
    if (use.pole) return fmt::format("a pole at {}", quoted(vertex_of(topology, edge.start).name));
    const int first = use.reversed ? edge.end : edge.start;
    const int last = use.reversed ? edge.start : edge.end;
    return fmt::format("{}, from {} to {}", use.reversed ? "backwards" : "forwards",
                       quoted(vertex_of(topology, first).name),
                       quoted(vertex_of(topology, last).name));
}

/// The face's own axis that a block's axis runs along on a side: "i is its -j".
std::string axes_text(Side side, const Orientation& orientation) {
    static constexpr std::array<char, 3> letters{'i', 'j', 'k'};
    std::string text;
    for (std::size_t n = 0; n < 2; ++n) {
        const auto own = static_cast<std::size_t>(tangential_axes(side)[n]);
        const int other = orientation.axes[n];
        text += fmt::format("{}{} along its {}{}", n == 0 ? "" : ", ", letters[own],
                            other < 0 ? "-" : "",
                            letters[static_cast<std::size_t>(std::abs(other) - 1)]);
    }
    return text;
}

void add_boundaries(const Topology& topology, int side, const Place& place,
                    std::vector<ExplanationStep>& steps) {
    for (const Boundary& boundary : topology.boundaries) {
        if (std::find(boundary.sides.begin(), boundary.sides.end(), side) == boundary.sides.end()) {
            continue;
        }
        steps.push_back({place, fmt::format("boundary {} ({})", quoted(boundary.family.name),
                                            boundary.family.type)});
    }
}

void add_faces_of_edge(const Topology& topology, int edge, std::vector<ExplanationStep>& steps) {
    for (const Face& face : topology.faces) {
        for (const Side side : face_sides) {
            for (const EdgeUse& use : face.side(side)) {
                if (use.edge != edge) continue;
                steps.push_back(
                    {face.place, fmt::format("{} of face {}: {}", side_name(side),
                                             quoted(face.name), run_text(topology, use))});
            }
        }
    }
}

Explanation edge_explanation(const Case& written, const Topology& topology, int index) {
    const Edge& edge = edge_of(topology, index);
    Explanation explanation{"edge " + quoted(edge.name), explain_edge(written, topology, index)};
    add_faces_of_edge(topology, index, explanation.steps);
    if (!topology.is_3d()) add_boundaries(topology, index, edge.place, explanation.steps);
    return explanation;
}

void add_blocks_of_face(const Topology& topology, int face, std::vector<ExplanationStep>& steps) {
    for (const Block& block : topology.blocks) {
        for (const Side side : all_sides) {
            for (const FaceUse& use : block.side(side).faces) {
                if (use.face != face) continue;
                steps.push_back({block.place, fmt::format("{} of block {}: {}", side_name(side),
                                                          quoted(block.name),
                                                          axes_text(side, use.orientation))});
            }
        }
    }
}

/// Of two opposite sides the one of fewer edges.
const std::vector<EdgeUse>& shorter(const std::vector<EdgeUse>& low,
                                    const std::vector<EdgeUse>& high) {
    return high.size() < low.size() ? high : low;
}

Explanation face_explanation(const Case& written, const Topology& topology, int index) {
    const Face& face = face_of(topology, index);
    Explanation explanation{"face " + quoted(face.name), {}};
    auto& steps = explanation.steps;
    steps.push_back(
        {face.place, fmt::format("{} x {} cells{}", face.cells_i, face.cells_j,
                                 face.made ? "; nobody drew it: made for a block's side" : "")});
    steps.push_back({face.place, fmt::format("corners: {}", corners_text(topology, face.corners))});
    for (const Side side : face_sides) {
        for (const EdgeUse& use : face.side(side)) {
            const Edge& edge = edge_of(topology, use.edge);
            steps.push_back(
                {edge.place, fmt::format("{}: edge {} {}, {} cells", side_name(side),
                                         quoted(edge.name), run_text(topology, use), edge.cells)});
        }
    }
    const Chains chains = chains_of(written, topology);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        explain_cells_along(written, chains, axis == 0 ? "i" : "j",
                            shorter(face.sides[2 - 2 * axis], face.sides[3 - 2 * axis]), face.place,
                            steps);
    }
    add_blocks_of_face(topology, index, steps);
    if (topology.is_3d()) add_boundaries(topology, index, face.place, steps);
    return explanation;
}

/// The edges of a block along each axis, where they are fewest.
std::array<std::vector<EdgeUse>, 3> edges_along(const Topology& topology, const Block& block) {
    const FrameSides on_jmin = sides_in_frame(topology.faces, block.side(Side::jmin));
    const FrameSides on_imin = sides_in_frame(topology.faces, block.side(Side::imin));
    return {shorter(on_jmin[2], on_jmin[3]), shorter(on_imin[2], on_imin[3]),
            shorter(on_imin[0], on_imin[1])};
}

Explanation block_explanation(const Case& written, const Topology& topology, const Block& block) {
    Explanation explanation{"block " + quoted(block.name), {}};
    auto& steps = explanation.steps;
    steps.push_back({block.place, fmt::format("{} x {} x {} cells", block.extent.ni - 1,
                                              block.extent.nj - 1, block.extent.nk - 1)});
    steps.push_back(
        {block.place, fmt::format("corners: {}", corners_text(topology, block.corners))});
    for (const Side side : all_sides) {
        for (const FaceUse& use : block.side(side).faces) {
            const Face& face = face_of(topology, use.face);
            steps.push_back(
                {face.place, fmt::format("{}: face {}, {}", side_name(side), quoted(face.name),
                                         axes_text(side, use.orientation))});
        }
    }
    const Chains chains = chains_of(written, topology);
    const auto edges = edges_along(topology, block);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        explain_cells_along(written, chains, std::string(1, "ijk"[axis]), edges.at(axis),
                            block.place, steps);
    }
    return explanation;
}

Explanation vertex_explanation(const Topology& topology, int index) {
    const Vertex& vertex = vertex_of(topology, index);
    Explanation explanation{"vertex " + quoted(vertex.name),
                            {{vertex.place, "at " + point_text(vertex.position)}}};
    for (const Edge& edge : topology.edges) {
        if (edge.start != index && edge.end != index) continue;
        explanation.steps.push_back(
            {edge.place, fmt::format("edge {} {} there", quoted(edge.name),
                                     edge.start == index ? "starts" : "ends")});
    }
    return explanation;
}

Explanation boundary_explanation(const Topology& topology, const Boundary& boundary) {
    Explanation explanation{"boundary " + quoted(boundary.family.name), {}};
    for (const int side : boundary.sides) {
        const auto s = static_cast<std::size_t>(side);
        const bool faces = topology.is_3d();
        explanation.steps.push_back(
            {faces ? topology.faces[s].place : topology.edges[s].place,
             fmt::format("{}: {} {}", boundary.family.type, faces ? "face" : "edge",
                         quoted(faces ? topology.faces[s].name : topology.edges[s].name))});
    }
    return explanation;
}

template <class Entity>
std::vector<int> named(const std::vector<Entity>& entities, const std::string& name) {
    std::vector<int> found;
    for (std::size_t n = 0; n < entities.size(); ++n) {
        if (entities[n].name == name) found.push_back(static_cast<int>(n));
    }
    return found;
}

/// With the instances of components that it comes from.
Explanation in_instances(Explanation explanation, const Place& place) {
    const std::vector<ExplanationStep> instances = instances_of(place);
    auto& steps = explanation.steps;
    steps.insert(steps.begin() + (steps.empty() ? 0 : 1), instances.begin(), instances.end());
    return explanation;
}

std::vector<Explanation> explain_entities(const Case& written, const Topology& topology,
                                          const std::string& name) {
    std::vector<Explanation> all;
    const std::string canonical = canonical_name(name);
    for (const int v : named(topology.vertices, name)) {
        all.push_back(in_instances(vertex_explanation(topology, v), vertex_of(topology, v).place));
    }
    for (const int e : named(topology.edges, canonical)) {
        all.push_back(
            in_instances(edge_explanation(written, topology, e), edge_of(topology, e).place));
    }
    for (const int f : named(topology.faces, canonical)) {
        all.push_back(
            in_instances(face_explanation(written, topology, f), face_of(topology, f).place));
    }
    for (const int b : named(topology.blocks, name)) {
        const Block& block = topology.blocks[static_cast<std::size_t>(b)];
        all.push_back(in_instances(block_explanation(written, topology, block), block.place));
    }
    for (const Boundary& boundary : topology.boundaries) {
        if (boundary.family.name == name) {
            all.push_back(boundary_explanation(topology, boundary));
        }
    }
    return all;
}

}  // namespace

std::vector<Explanation> explain(const Case& written, const Topology& topology,
                                 const std::string& name) {
    std::vector<Explanation> all = explain_instances(written, name);
    for (const JoinedPart& part : parts_of_ports(written, name)) {
        all.push_back({text_of(part), {{part.place, "joined here"}}});
        for (Explanation& now : explain_entities(written, topology, part.outside)) {
            if (now.title == part.kind + " " + quoted(part.outside)) all.push_back(std::move(now));
        }
    }
    for (Explanation& entity : explain_entities(written, topology, name)) {
        all.push_back(std::move(entity));
    }
    return all;
}

std::vector<std::string> explained_names(const Case& written, const Topology& topology) {
    std::set<std::string> names;
    for (const Vertex& v : topology.vertices) names.insert(v.name);
    for (const Edge& e : topology.edges) names.insert(e.name);
    for (const Face& f : topology.faces) names.insert(f.name);
    for (const Block& b : topology.blocks) names.insert(b.name);
    for (const Boundary& b : topology.boundaries) names.insert(b.family.name);
    for (const InstanceEntry& i : written.instances) names.insert(i.name.value);
    for (const JoinedPart& part : written.joined) names.insert(part.name);
    return {names.begin(), names.end()};
}

std::string to_text(const Explanation& explanation) {
    std::vector<std::string> places;
    std::size_t width = 0;
    for (const ExplanationStep& step : explanation.steps) {
        const Place& p = step.place;
        places.push_back(p.file == nullptr ? "" : fmt::format("{}:{}", p.file->name, p.line));
        width = std::max(width, places.back().size());
    }
    std::string text = explanation.title + "\n";
    for (std::size_t n = 0; n < places.size(); ++n) {
        text += fmt::format("  {:<{}}  {}\n", places[n], width, explanation.steps[n].text);
    }
    return text;
}

}  // namespace hexweave
