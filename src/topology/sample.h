// SPDX-License-Identifier: Apache-2.0
// A few points of an edge or a side: enough to tell signs and sizes by, not a grid.
#pragma once

#include <algorithm>
#include <vector>

#include "core/vec3.h"
#include "topology/topology.h"

namespace hexweave {

/// The point at a fraction of the edge's range of its curve's parameter, along its direction.
Vec3 point_at(const Edge& edge, double fraction);
/// `intervals` + 1 points at equal steps of the curve's parameter, along the edge's direction.
std::vector<Vec3> sample_edge(const Edge& edge, int intervals);
/// `intervals` + 1 points along a side of one or several edges, each edge with a part of the
/// intervals' range in proportion to its length. The same uses run backwards give the same points.
std::vector<Vec3> sample_side(const std::vector<Edge>& edges, const std::vector<EdgeUse>& side,
                              int intervals);
/// The corners of the axis-parallel box around some points; a point at the origin when there are
/// none.
struct Box {
    Vec3 low;
    Vec3 high;

    double diagonal() const { return distance(low, high); }
};
Box box_around(const std::vector<Vec3>& points);

/// How far a grid reaches to either side of an axis or a plane.
struct AxisReach {
    double low = 0;
    double high = 0;
};

inline void include(AxisReach& reach, double off) {
    reach.low = std::min(reach.low, off);
    reach.high = std::max(reach.high, off);
}

}  // namespace hexweave
