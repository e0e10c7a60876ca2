// SPDX-License-Identifier: Apache-2.0
// How fast cells grow along grid lines, inside a zone and from one zone to the next.
#pragma once

#include <array>

#include "core/field.h"
#include "core/multiblock.h"
#include "core/vec3.h"

namespace hexweave {

/// The greatest ratio of two intervals that follow each other on a grid line, the longer over the
/// shorter; 1 where no line has two. Intervals without length, at a pole, do not count.
struct GrowthMeasure {
    double ratio = 1;
    Vec3 place;  ///< the node between the two

    void include(double length, double next_length, const Vec3& at);
};

/// Along the lines of i, j and k.
std::array<GrowthMeasure, 3> measure_growth(const PointField& points);
/// Along the lines that cross an interface: the intervals before and behind it.
GrowthMeasure measure_growth(const MultiblockGrid& grid, const Interface& interface);

}  // namespace hexweave
