// SPDX-License-Identifier: Apache-2.0
#include "topology/case_positions.h"

#include <memory>
#include <utility>
#include <vector>

#include "geometry/surface_set.h"
#include "topology/sample.h"

namespace hexweave {

namespace {

template <class Entry>
const Entry* find_shape(const std::vector<Entry>& entries, const std::string& name) {
    for (const Entry& entry : entries) {
        if (entry.name.value == name) return entry.shape ? &entry : nullptr;
    }
    return nullptr;
}

std::optional<Vec3> position_on(const Case& c, const OnSurface& place) {
    std::vector<std::shared_ptr<const Surface>> surfaces;
    for (const Name& name : place.surfaces) {
        const SurfaceEntry* surface = find_shape(c.surfaces, name.value);
        if (surface == nullptr) return std::nullopt;
        surfaces.push_back(surface->shape);
    }
    if (surfaces.empty()) return std::nullopt;
    if (const auto* at = std::get_if<SurfaceParameters>(&place.where)) {
        return evaluate(*surfaces.front(), *at);
    }
    return SurfaceSet(surfaces).nearest(std::get<Vec3>(place.where)).point.position;
}

std::optional<Vec3> position_of(const Case& c, const VertexEntry& vertex) {
    if (const auto* point = std::get_if<Vec3>(&vertex.where)) return *point;
    if (const auto* place = std::get_if<OnSurface>(&vertex.where)) return position_on(c, *place);
    const auto& where = std::get<OnCurve>(vertex.where);
    const CurveEntry* curve = find_shape(c.curves, where.curve.value);
    if (curve == nullptr) return std::nullopt;
    return evaluate(*curve->shape, parameter_at_fraction(*curve->shape, where.at));
}

}  // namespace

Positions::Positions(const Case& c) {
    std::vector<Vec3> points;
    for (const VertexEntry& vertex : c.vertices) {
        const std::optional<Vec3> position = position_of(c, vertex);
        if (!position) continue;
        positions_.emplace(vertex.name.value, *position);
        points.push_back(*position);
    }
    if (!points.empty()) size_ = box_around(points).diagonal();
}

std::optional<Vec3> Positions::of(const std::string& vertex) const {
    const auto found = positions_.find(vertex);
    return found == positions_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace hexweave
