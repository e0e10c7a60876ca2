// SPDX-License-Identifier: Apache-2.0
#include "quality/growth.h"

#include <algorithm>

#include "quality/lines_across.h"

namespace hexweave {

void GrowthMeasure::include(double length, double next_length, const Vec3& at_node) {
    const double shorter = std::min(length, next_length);
    if (!(shorter > 0)) return;
    const double found = std::max(length, next_length) / shorter;
    if (measured && found <= ratio) return;
    measured = true;
    ratio = found;
    place = at_node;
}

std::array<GrowthMeasure, 3> measure_growth(const PointField& points) {
    std::array<GrowthMeasure, 3> growth;
    for_intervals(points, [&](std::size_t axis, double length, double next, const Vec3& node) {
        growth[axis].include(length, next, node);
    });
    return growth;
}

GrowthMeasure measure_growth(const MultiblockGrid& grid, const Interface& interface) {
    GrowthMeasure growth;
    for_lines_across(grid, interface,
                     [&](const Vec3& before, const Vec3& node, const Vec3& behind) {
                         growth.include(distance(before, node), distance(node, behind), node);
                     });
    return growth;
}

}  // namespace hexweave
