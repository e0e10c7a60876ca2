// SPDX-License-Identifier: Apache-2.0
#include "io/json_values.h"

#include <cmath>

namespace hexweave {

Json json_of(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_of(const std::optional<double>& value) {
    return value ? json_of(*value) : Json(nullptr);
}

Json json_of(const Vec3& point) {
    return {json_of(point.x), json_of(point.y), json_of(point.z)};
}

Json json_of(const std::optional<Vec3>& point) {
    return point ? json_of(*point) : Json(nullptr);
}

Json json_of(const Extent& extent) {
    return {extent.ni, extent.nj, extent.nk};
}

Json json_of(const Node& index) {
    return {index[0] + 1, index[1] + 1, index[2] + 1};
}

Json json_of(const AngleMeasure& a) {
    return {{"corners", a.corners},
            {"least", json_of(a.least)},
            {"greatest", json_of(a.greatest)},
            {"worst_place", json_of(a.worst_place())},
            {"least_place", json_of(a.least_place)},
            {"greatest_place", json_of(a.greatest_place)},
            {"within_5", a.within_5},
            {"within_10", a.within_10}};
}

Json json_of(const GrowthMeasure& g) {
    if (!g.measured) return {{"ratio", nullptr}, {"place", nullptr}};
    return {{"ratio", json_of(g.ratio)}, {"place", json_of(g.place)}};
}

Json json_of(const WallMeasure& w) {
    const bool has_angles = w.nodes > 0;
    return {{"family", w.family},
            {"nodes", w.nodes},
            {"mean_angle", has_angles ? json_of(w.mean_angle) : Json(nullptr)},
            {"greatest_angle", has_angles ? json_of(w.greatest_angle) : Json(nullptr)},
            {"worst_place", has_angles ? json_of(w.worst_place) : Json(nullptr)},
            {"greatest_angle_beside_ends", json_of(w.greatest_angle_beside_ends)},
            {"least_height", json_of(w.least_height)},
            {"median_height", json_of(w.median_height)},
            {"greatest_height", json_of(w.greatest_height)}};
}

Json json_of(const ZoneMeasure& z) {
    // Corners inside are there where every axis has nodes between its ends.
    const bool has_inside = z.extent.ni > 2 && z.extent.nj > 2 && z.extent.nk != 2;
    return {{"name", z.name},
            {"nodes", json_of(z.extent)},
            {"cells", z.cells},
            {"folded", z.folded},
            {"flat_corners", z.flat_corners},
            {"pole_corners", z.pole_corners},
            {"worst_scaled_jacobian", json_of(z.worst_scaled_jacobian)},
            {"worst_inside", has_inside ? json_of(z.worst_inside) : Json(nullptr)},
            {"worst_cell", json_of(z.worst_cell)},
            {"worst_place", json_of(z.worst_place)},
            {"angles", json_of(z.angles)},
            {"growth", {json_of(z.growth[0]), json_of(z.growth[1]), json_of(z.growth[2])}}};
}

}  // namespace hexweave
