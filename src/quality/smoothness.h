// SPDX-License-Identifier: Apache-2.0
// How much grid lines bend from one node to the next, inside a zone and from one zone to the next.
#pragma once

#include <array>
#include <cstddef>

#include "core/field.h"
#include "core/multiblock.h"
#include "core/vec3.h"

namespace hexweave {

/// The angles, in degrees, between the intervals before and behind the nodes of grid lines: 0 where
/// a line runs straight on. The greatest and the mean are the maximum and the average deviation
/// from smoothness (MDS, ADS) of [Villamizar & Acosta 2009, section 6.2]. Intervals without length,
/// at a pole, do not count.
struct BendMeasure {
    std::size_t nodes = 0;
    double greatest = 0;
    double sum = 0;
    Vec3 place;  ///< of the greatest

    double mean() const { return nodes > 0 ? sum / static_cast<double>(nodes) : 0; }
    void include(const Vec3& before, const Vec3& behind, const Vec3& at);
    void include(const BendMeasure& other);
};

/// Along the lines of i, j and k, at the nodes inside each line.
std::array<BendMeasure, 3> measure_bends(const PointField& points);
/// Along the lines that cross an interface, at its nodes: the slope break.
BendMeasure measure_bends(const MultiblockGrid& grid, const Interface& interface);

}  // namespace hexweave
