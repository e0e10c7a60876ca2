// SPDX-License-Identifier: Apache-2.0
#include "faces/folded_start.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hexweave {

namespace {

/// A fractional node index along one axis: the node below and the fraction of the way to the next.
struct Station {
    int below = 0;
    double fraction = 0;
};

/// The station at `place` of an axis, 0 to 1, reflected where it lies outside.
Station station(double place, int count) {
    if (count == 1) return {};
    const double inside = place < 0 ? -place : place > 1 ? 2 - place : place;
    const double index = inside * (count - 1);
    const int below = std::min(static_cast<int>(index), count - 2);
    return {below, index - below};
}

Vec3 sample(const PointField& points, const Station& i, const Station& j, const Station& k) {
    const auto along_i = [&](int row, int layer) {
        const int next = points.extent().ni > 1 ? i.below + 1 : i.below;
        return lerp(points(i.below, row, layer), points(next, row, layer), i.fraction);
    };
    const auto along_j = [&](int layer) {
        return lerp(along_i(j.below, layer), along_i(j.below + 1, layer), j.fraction);
    };
    if (points.extent().nk == 1) return along_j(0);
    return lerp(along_j(k.below), along_j(k.below + 1), k.fraction);
}

}  // namespace

void fold_interior(PointField& points) {
    const PointField before = points;
    const Extent extent = points.extent();
    const bool is_face = extent.nk == 1;
    for (int k = is_face ? 0 : 1; k < (is_face ? 1 : extent.nk - 1); ++k) {
        const double w = is_face ? 0.5 : static_cast<double>(k) / (extent.nk - 1);
        for (int j = 1; j < extent.nj - 1; ++j) {
            const double v = static_cast<double>(j) / (extent.nj - 1);
            for (int i = 1; i < extent.ni - 1; ++i) {
                const double u = static_cast<double>(i) / (extent.ni - 1);
                const double height = 0.5 * std::sin(std::numbers::pi * u) *
                                      std::sin(std::numbers::pi * v) *
                                      std::sin(std::numbers::pi * w);
                points.set(i, j, k,
                           sample(before, station(u + height * std::sin(9 * v + 3 * w), extent.ni),
                                  station(v + height * std::cos(8 * w - 5 * u), extent.nj),
                                  station(w + height * std::sin(7 * u + 9 * v), extent.nk)));
            }
        }
    }
}

}  // namespace hexweave
