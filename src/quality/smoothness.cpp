// SPDX-License-Identifier: Apache-2.0
#include "quality/smoothness.h"

#include "core/parallel.h"
#include "quality/angles.h"
#include "quality/lines_across.h"

namespace hexweave {

void BendMeasure::include(const Vec3& before, const Vec3& behind, const Vec3& at) {
    if (before == Vec3{} || behind == Vec3{}) return;
    const double angle = angle_between(before, behind);
    ++nodes;
    sum += angle;
    if (angle <= greatest) return;
    greatest = angle;
    place = at;
}

void BendMeasure::include(const BendMeasure& other) {
    nodes += other.nodes;
    sum += other.sum;
    if (other.greatest <= greatest) return;
    greatest = other.greatest;
    place = other.place;
}

std::array<BendMeasure, 3> measure_bends(const PointField& points) {
    const Extent e = points.extent();
    std::array<BendMeasure, 3> bends;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Node first{};
        first[axis] = 1;
        const auto at = [&](int i, int j, int k, int step) {
            return points(i + step * first[0], j + step * first[1], k + step * first[2]);
        };
        std::vector<BendMeasure> layers(static_cast<std::size_t>(e.nk));
        parallel_for(layers.size(), [&](std::size_t layer) {
            const int k = static_cast<int>(layer);
            if (k < first[2] || k >= e.nk - first[2]) return;
            for (int j = first[1]; j < e.nj - first[1]; ++j) {
                for (int i = first[0]; i < e.ni - first[0]; ++i) {
                    const Vec3 p = points(i, j, k);
                    layers[layer].include(p - at(i, j, k, -1), at(i, j, k, 1) - p, p);
                }
            }
        });
        for (const BendMeasure& layer : layers) bends[axis].include(layer);
    }
    return bends;
}

BendMeasure measure_bends(const MultiblockGrid& grid, const Interface& interface) {
    BendMeasure bends;
    for_lines_across(grid, interface, [&](const Vec3& before, const Vec3& at, const Vec3& behind) {
        bends.include(at - before, behind - at, at);
    });
    return bends;
}

}  // namespace hexweave
