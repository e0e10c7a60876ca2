// SPDX-License-Identifier: Apache-2.0
#include "quality/first_heights.h"

#include <algorithm>

#include "faces/wall_frame.h"
#include "quality/walls.h"

namespace hexweave {

namespace {

HeightMeasure measure(const HeldSide& side, const std::vector<HeightRatio>& ratios) {
    const double* const asked = side.asked.data();
    const auto [least, greatest] = std::minmax_element(asked, asked + side.asked.extent().nodes());
    HeightMeasure row;
    row.side = side.side;
    row.least_asked = *least;
    row.greatest_asked = *greatest;
    row.least = ratios.front().value;
    row.least_place = ratios.front().place;
    row.median = ratios[ratios.size() / 2].value;
    row.greatest = ratios.back().value;
    row.greatest_place = ratios.back().place;
    return row;
}

HeightMeasure measure_held(const PointField& points, const HeldSide& held) {
    HeightMeasure row = measure(held, height_ratios(points, held));
    row.stopped = held.stopped;
    const WallFrame wall(points.extent(), held.side);
    const std::vector<HeightRatio> ends =
        height_ratios(points, held, [&](int a, int b) { return wall.fixed(a, b); });
    row.ends_amiss = static_cast<std::size_t>(std::count_if(
        ends.begin(), ends.end(),
        [](const HeightRatio& ratio) { return HeightMeasure::is_amiss(ratio.value); }));
    return row;
}

/// 1 at the nodes of a side that are on walls.
Field wall_nodes(const MultiblockGrid& grid, std::size_t zone, const WallFrame& wall) {
    Field marks(wall.nodes());
    const auto normal = static_cast<std::size_t>(axis_of(wall.side));
    const int at = is_max(wall.side) ? wall.depth() - 1 : 0;
    const auto a_axis = static_cast<std::size_t>(wall.axes[0]);
    const auto b_axis = static_cast<std::size_t>(wall.axes[1]);
    for (const BoundaryPatch& patch : grid.patches) {
        const Family& family = grid.families[static_cast<std::size_t>(patch.family)];
        const IndexBox& box = patch.box;
        if (patch.zone != static_cast<int>(zone) || !is_wall(family)) continue;
        if (box.begin[normal] != at || box.end[normal] != at) continue;
        const int last_b = wall.is_line() ? 0 : box.end[b_axis];
        for (int b = wall.is_line() ? 0 : box.begin[b_axis]; b <= last_b; ++b) {
            for (int a = box.begin[a_axis]; a <= box.end[a_axis]; ++a) marks(a, b) = 1;
        }
    }
    return marks;
}

/// Whether an edge begins with these two points and asks for its first cell, or ends with them.
bool asks(const Edge& edge, const EdgeGrid& grid, const Vec3& end, const Vec3& next) {
    const std::vector<Vec3>& x = grid.points;
    return (edge.asked_start && x.front() == end && x[1] == next) ||
           (edge.asked_end && x.back() == end && x[x.size() - 2] == next);
}

bool edges_ask(const AskingWalls& walls, const PointField& points, const WallFrame& wall) {
    for (const int b : {0, wall.count_b - 1}) {
        for (const int a : {0, wall.count_a - 1}) {
            const Vec3 corner = points[wall.offset(a, b, 0)];
            const Vec3 next = points[wall.offset(a, b, 1)];
            for (std::size_t e = 0; e < walls.edges.size(); ++e) {
                if (asks(walls.topology.edges[e], walls.edges[e], corner, next)) return true;
            }
        }
    }
    return false;
}

}  // namespace

std::vector<HeightMeasure> first_heights(const AskingWalls* walls, std::size_t zone,
                                         const PointField& points,
                                         const std::vector<HeldSide>& held) {
    std::vector<HeightMeasure> rows;
    rows.reserve(held.size());
    for (const HeldSide& side : held) rows.push_back(measure_held(points, side));
    if (walls == nullptr) return rows;
    for (const Side side : all_sides) {
        if (points.extent()[axis_of(side)] == 1) continue;
        if (std::any_of(held.begin(), held.end(),
                        [side](const HeldSide& h) { return h.side == side; })) {
            continue;
        }
        const WallFrame wall(points.extent(), side);
        const Field marks = wall_nodes(walls->grid, zone, wall);
        const double* const begin = marks.data();
        if (std::count(begin, begin + wall.nodes().nodes(), 1.0) == 0) continue;
        if (!edges_ask(*walls, points, wall)) continue;
        const HeldSide asked{side, 0, asked_heights(points, side, std::nullopt)};
        const auto counts = [&](int a, int b) { return marks(a, b) != 0; };
        rows.push_back(measure(asked, height_ratios(points, asked, counts)));
        rows.back().held = false;
    }
    return rows;
}

}  // namespace hexweave
