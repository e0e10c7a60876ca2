// SPDX-License-Identifier: Apache-2.0
#include "quality/growth.h"

#include <algorithm>

namespace hexweave {

namespace {

Vec3 at(const PointField& x, const Node& n) {
    return x(n[0], n[1], n[2]);
}

/// Of a box that is a part of a side of a zone: the step of nodes from the side into the zone.
Node inward_step(const IndexBox& box, const Extent& extent) {
    Node step{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int last = extent[static_cast<int>(axis)] - 1;
        if (last == 0 || box.begin[axis] != box.end[axis]) continue;
        step[axis] = box.begin[axis] == 0 ? 1 : -1;
        break;
    }
    return step;
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
    const PointField& own = grid.zones[static_cast<std::size_t>(interface.zone)].points;
    const PointField& donor = grid.zones[static_cast<std::size_t>(interface.donor)].points;
    const IndexBox& box = interface.box;
    const Node inward = inward_step(box, own.extent());
    const Node onward = inward_step(interface.donor_box, donor.extent());
    GrowthMeasure growth;
    for (int k = box.begin[2]; k <= box.end[2]; ++k) {
        for (int j = box.begin[1]; j <= box.end[1]; ++j) {
            for (int i = box.begin[0]; i <= box.end[0]; ++i) {
                const Node n{i, j, k};
                const Node m = donor_node(interface, n);
                growth.include(distance(at(own, n), at(own, n + inward)),
                               distance(at(donor, m), at(donor, m + onward)), at(own, n));
            }
        }
    }
    return growth;
}

}  // namespace hexweave
