// SPDX-License-Identifier: Apache-2.0
// How fast cells grow along grid lines, inside a zone and from one zone to the next.
#pragma once

#include <array>
#include <cstddef>

#include "core/field.h"
#include "core/multiblock.h"
#include "core/vec3.h"

namespace hexweave {

/// The greatest ratio of two intervals that follow each other on a grid line, the longer over the
/// shorter; 1 where no line has two. Intervals without length, at a pole, do not count.
struct GrowthMeasure {
    double ratio = 1;
    Vec3 place;             ///< the node between the two
    bool measured = false;  ///< whether a line has two

    void include(double length, double next_length, const Vec3& at);
};

/// Calls visit(axis, length, next_length, node) for every two intervals that follow each other on a
/// grid line of i, j or k.
template <class Visit>
void for_intervals(const PointField& points, Visit&& visit) {
    const Extent e = points.extent();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Node step{};
        step[axis] = 1;
        for (int k = step[2]; k < e.nk - step[2]; ++k) {
            for (int j = step[1]; j < e.nj - step[1]; ++j) {
                for (int i = step[0]; i < e.ni - step[0]; ++i) {
                    const Vec3 p = points(i, j, k);
                    visit(axis, distance(points(i - step[0], j - step[1], k - step[2]), p),
                          distance(p, points(i + step[0], j + step[1], k + step[2])), p);
                }
            }
        }
    }
}

/// Along the lines of i, j and k.
std::array<GrowthMeasure, 3> measure_growth(const PointField& points);
/// Along the lines that cross an interface: the intervals before and behind it.
GrowthMeasure measure_growth(const MultiblockGrid& grid, const Interface& interface);

}  // namespace hexweave
