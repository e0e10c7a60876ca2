// SPDX-License-Identifier: Apache-2.0
#include "topology/surface_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "geometry/surface_patch.h"
#include "geometry/surface_set.h"
#include "topology/sample.h"
#include "topology/text.h"

namespace hexweave {

namespace {

constexpr double on_surface = 1e-6;  // of the surface's size
constexpr int intervals = 32;

/// The surfaces as a message names them: the one, or any of several.
std::string target_text(const std::vector<Name>& names) {
    if (names.size() == 1) return fmt::format("the surface {}", quoted(names.front().value));
    return fmt::format("any of the {}", surfaces_text(names));
}

/// A parameter as messages show it: round-off is zero.
std::string parameter_text(double value, const std::array<double, 2>& range) {
    return number_text(std::abs(value) <= 1e-12 * (range[1] - range[0]) ? 0 : value);
}

/// Reports an edge that is off the surfaces, where it is farthest off.
bool check_edge(const Edge& edge, const FaceEntry& face, const SurfaceSet& surfaces,
                Diagnostics& diagnostics) {
    const std::vector<Vec3> points = sample_edge(edge, intervals);
    const std::vector<PatchPoint> feet = surfaces.along(points);
    const auto farthest =
        std::max_element(feet.begin(), feet.end(), [](const PatchPoint& a, const PatchPoint& b) {
            return a.point.distance < b.point.distance;
        });
    const SurfacePoint& foot = farthest->point;
    if (foot.distance <= face.gap.value_or(on_surface * surfaces.size())) return true;
    const std::vector<Name>& names = face.surfaces;
    const Surface& surface = surfaces.surface(farthest->patch);
    const std::string nearest =
        names.size() == 1
            ? "the surface"
            : fmt::format("{}", quoted(names[static_cast<std::size_t>(farthest->patch)].value));
    Diagnostic& error = diagnostics.error(
        names.front().place,
        fmt::format("edge {} is not on {}: it is {} away at {}", quoted(edge.name),
                    target_text(names), number_text(foot.distance),
                    point_text(points[static_cast<std::size_t>(farthest - feet.begin())])),
        fmt::format("the nearest point of {} is {}, at u = {}, v = {}", nearest,
                    point_text(foot.position), parameter_text(foot.parameters.u, surface.range_u),
                    parameter_text(foot.parameters.v, surface.range_v)));
    if (!edge.made) error.notes.push_back({edge.place, "the edge stands here"});
    return false;
}

/// Whether the face's boundary comes back to the parameters that it began with.
bool check_loop(const Network& network, const Face& face, const Name& surface,
                const SurfaceProjection& projection, Diagnostics& diagnostics) {
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

bool check_face(const Network& network, const Face& face, const FaceEntry& entry,
                Diagnostics& diagnostics) {
    const SurfaceSet surfaces(face.surface ? std::vector{face.surface} : face.patches);
    std::set<int> edges;
    for (const auto& side : face.sides) {
        for (const EdgeUse& use : side) edges.insert(use.edge);
    }
    bool sound = true;
    for (const int edge : edges) {
        sound = check_edge(network.edge(edge), entry, surfaces, diagnostics) && sound;
    }
    if (!sound || !face.surface) return sound;
    return check_loop(network, face, entry.surfaces.front(), surfaces.projection(0), diagnostics);
}

}  // namespace

bool check_surface_faces(const Network& network, Diagnostics& diagnostics) {
    bool sound = true;
    for (std::size_t n = 0; n < network.topology.faces.size(); ++n) {
        const Face& face = network.topology.faces[n];
        const FaceEntry* entry = network.face_entries[n];
        if (entry == nullptr || entry->surfaces.empty()) continue;
        // A surface that is not there has been told of.
        sound = face.is_on_surface() && check_face(network, face, *entry, diagnostics) && sound;
    }
    return sound;
}

}  // namespace hexweave
