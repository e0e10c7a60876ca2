// SPDX-License-Identifier: Apache-2.0
#include "quality/growth.h"

#include <algorithm>

#include "quality/lines_across.h"

namespace hexweave {

namespace {

Vec3 at(const PointField& x, const Node& n) {
    return x(n[0], n[1], n[2]);
}

Node operator+(const Node& a, const Node& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

}  // namespace

void GrowthMeasure::include(double length, double next_length, const Vec3& at_node) {
    const double shorter = std::min(length, next_length);
    if (!(shorter > 0)) return;
    const double found = std::max(length, next_length) / shorter;
    if (found <= ratio) return;
    ratio = found;
    place = at_node;
}

std::array<GrowthMeasure, 3> measure_growth(const PointField& points) {
    const Extent e = points.extent();
    std::array<GrowthMeasure, 3> growth;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Node first{};
        Node step{};
        first[axis] = 1;
        step[axis] = 1;
        const Node back{-step[0], -step[1], -step[2]};
        for (int k = first[2]; k < e.nk - first[2]; ++k) {
            for (int j = first[1]; j < e.nj - first[1]; ++j) {
                for (int i = first[0]; i < e.ni - first[0]; ++i) {
                    const Node n{i, j, k};
                    const Vec3 p = at(points, n);
                    growth[axis].include(distance(at(points, n + back), p),
                                         distance(p, at(points, n + step)), p);
                }
            }
        }
    }
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
