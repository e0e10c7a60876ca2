// SPDX-License-Identifier: Apache-2.0
// The measures of one cell, without those that need its neighbours.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/field.h"
#include "core/orientation.h"
#include "core/vec3.h"
#include "quality/cell_corners.h"
#include "quality/jacobian_bound.h"

namespace hexweave {

/// The nodes of a block's cell, in the order of its corners; of a surface cell the first four.
CellNodes cell_nodes(const PointField& x, const Node& cell);

/// Longest over shortest edge, edges without length apart; `axes` is 2 for a surface cell, else 3.
double cell_aspect_ratio(const CellNodes& nodes, std::size_t axes);

/// Half the product of the diagonals of a surface cell; where the zone has a plane seen along its
/// normal, with sign.
double surface_cell_area(const CellNodes& nodes, const Vec3& plane);

/// Calls visit(degrees from 90) for the angle at every corner between every pair of axes; an angle
/// at an edge without length does not count.
template <class Visit>
void visit_deviations(const CellNodes& nodes, std::size_t axes, Visit&& visit) {
    constexpr double degrees = 57.295779513082321;
    for (std::size_t c = 0; c < (std::size_t{1} << axes); ++c) {
        for (std::size_t a = 0; a < axes; ++a) {
            for (std::size_t b = a + 1; b < axes; ++b) {
                const Vec3 p = nodes[c ^ (std::size_t{1} << a)] - nodes[c];
                const Vec3 q = nodes[c ^ (std::size_t{1} << b)] - nodes[c];
                const double lengths = dot(p, p) * dot(q, q);
                if (!(lengths > 0)) continue;
                const double cosine = dot(p, q) / std::sqrt(lengths);
                visit(std::asin(std::min(std::abs(cosine), 1.0)) * degrees);
            }
        }
    }
}

struct CellMeasures {
    double scaled_jacobian = 1;  ///< the least of its corners, flat ones and poles apart
    double skewness = 0;         ///< equiangle: the greatest |angle - 90| / 90
    double aspect_ratio = 1;
    double volume = 0;  ///< the area of a surface cell
};

/// `plane`: as zone_plane gives it.
CellMeasures measure_cell(const PointField& x, const Node& cell, const Vec3& plane);

}  // namespace hexweave
