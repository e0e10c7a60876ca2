// SPDX-License-Identifier: Apache-2.0
#include "topology/sample.h"

#include <algorithm>
#include <cstddef>

#include "core/assert.h"

namespace hexweave {

Vec3 point_at(const Edge& edge, double fraction) {
    return evaluate(*edge.curve, edge.from + (edge.to - edge.from) * fraction);
}

std::vector<Vec3> sample_edge(const Edge& edge, int intervals) {
    std::vector<Vec3> points;
    points.reserve(static_cast<std::size_t>(intervals) + 1);
    for (int n = 0; n <= intervals; ++n) {
        points.push_back(point_at(edge, static_cast<double>(n) / intervals));
    }
    return points;
}

std::vector<Vec3> sample_side(const std::vector<Edge>& edges, const std::vector<EdgeUse>& side,
                              int intervals) {
    HEXWEAVE_ASSERT(!side.empty());
    double whole = 0;
    for (const EdgeUse& use : side) whole += edges[static_cast<std::size_t>(use.edge)].length;
    std::vector<Vec3> points;
    points.reserve(static_cast<std::size_t>(intervals) + 1);
    std::size_t position = 0;
    double before = 0;
    for (int n = 0; n <= intervals; ++n) {
        const double length = whole * n / intervals;
        const auto edge_of = [&](std::size_t p) -> const Edge& {
            return edges[static_cast<std::size_t>(side[p].edge)];
        };
        while (position + 1 < side.size() && length > before + edge_of(position).length) {
            before += edge_of(position).length;
            ++position;
        }
        const Edge& edge = edge_of(position);
        const double fraction =
            edge.pole ? 0.0 : std::clamp((length - before) / edge.length, 0.0, 1.0);
        points.push_back(point_at(edge, side[position].reversed ? 1 - fraction : fraction));
    }
    return points;
}

Box box_around(const std::vector<Vec3>& points) {
    if (points.empty()) return {};
    Box box{points.front(), points.front()};
    for (const Vec3& p : points) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y),
                    std::max(box.high.z, p.z)};
    }
    return box;
}

}  // namespace hexweave
