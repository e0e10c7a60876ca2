// SPDX-License-Identifier: Apache-2.0
#include "topology/surface_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "geometry/surface_patch.h"
#include "topology/sample.h"
#include "topology/text.h"

namespace hexweave {

namespace {

constexpr double on_surface = 1e-6;  // of the surface's size
constexpr int intervals = 32;

/// Reports an edge that is off the surface, where it is farthest off.
bool check_edge(const Edge& edge, const Name& surface, const SurfaceProjection& projection,
                Diagnostics& diagnostics) {
    const std::vector<Vec3> points = sample_edge(edge, intervals);
    const std::vector<SurfacePoint> feet = projection.along(points);
    const auto farthest = std::max_element(
        feet.begin(), feet.end(),
        [](const SurfacePoint& a, const SurfacePoint& b) { return a.distance < b.distance; });
    if (farthest->distance <= on_surface * projection.size()) return true;
    Diagnostic& error = diagnostics.error(
        surface.place,
        fmt::format("edge {} is not on the surface {}: it is {} away at {}", quoted(edge.name),
                    quoted(surface.value), number_text(farthest->distance),
                    point_text(points[static_cast<std::size_t>(farthest - feet.begin())])),
        fmt::format("the nearest point of the surface is {}, at u = {}, v = {}",
                    point_text(farthest->position), number_text(farthest->parameters.u),
                    number_text(farthest->parameters.v)));
    if (!edge.made) error.notes.push_back({edge.place, "the edge stands here"});
    return false;
}

bool check_face(const Network& network, const Face& face, const Name& surface,
                Diagnostics& diagnostics) {
    const SurfaceProjection projection(*face.surface);
    std::set<int> edges;
    for (const auto& side : face.sides) {
        for (const EdgeUse& use : side) edges.insert(use.edge);
    }
    bool sound = true;
    for (const int edge : edges) {
        sound = check_edge(network.edge(edge), surface, projection, diagnostics) && sound;
    }
    if (!sound) return false;
    std::array<std::vector<Vec3>, 4> sides;
    for (std::size_t n = 0; n < 4; ++n) {
        sides[n] = sample_side(network.topology.edges, face.sides[n], intervals);
    }
    if (sides_on_surface(projection, sides).closes) return true;
    diagnostics.error(
        surface.place,
        fmt::format("the boundary of face {} goes round the surface {}", quoted(face.name),
                    quoted(surface.value)),
        "on the way round its parameters do not come back: a pole lies inside, or it is a band "
        "round the surface; split the face, or turn the surface's axis");
    return false;
}

}  // namespace

bool check_surface_faces(const Network& network, Diagnostics& diagnostics) {
    bool sound = true;
    for (std::size_t n = 0; n < network.topology.faces.size(); ++n) {
        const Face& face = network.topology.faces[n];
        const FaceEntry* entry = network.face_entries[n];
        if (entry == nullptr || !entry->surface) continue;
        // A surface that is not there has been told of.
        sound = face.surface && check_face(network, face, *entry->surface, diagnostics) && sound;
    }
    return sound;
}

}  // namespace hexweave
