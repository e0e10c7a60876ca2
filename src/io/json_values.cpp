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
            {"worst_place", json_of(a.worst_place)},
            {"within_5", a.within_5},
            {"within_10", a.within_10}};
}

Json json_of(const GrowthMeasure& g) {
    return {{"ratio", json_of(g.ratio)}, {"place", json_of(g.place)}};
}

Json json_of(const WallMeasure& w) {
    return {{"family", w.family},
            {"nodes", w.nodes},
            {"mean_angle", json_of(w.mean_angle)},
            {"greatest_angle", json_of(w.greatest_angle)},
            {"worst_place", json_of(w.worst_place)},
            {"greatest_angle_beside_ends", json_of(w.greatest_angle_beside_ends)},
            {"least_height", json_of(w.least_height)},
            {"median_height", json_of(w.median_height)},
            {"greatest_height", json_of(w.greatest_height)}};
}

Json json_of(const ZoneMeasure& z) {
    return {{"name", z.name},
            {"nodes", json_of(z.extent)},
            {"cells", z.cells},
            {"folded", z.folded},
            {"flat_corners", z.flat_corners},
            {"pole_corners", z.pole_corners},
            {"worst_scaled_jacobian", json_of(z.worst_scaled_jacobian)},
            {"worst_inside", json_of(z.worst_inside)},
            {"worst_cell", json_of(z.worst_cell)},
            {"worst_place", json_of(z.worst_place)},
            {"angles", json_of(z.angles)},
            {"growth", {json_of(z.growth[0]), json_of(z.growth[1]), json_of(z.growth[2])}}};
}

}  // namespace hexweave
