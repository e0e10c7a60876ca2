// SPDX-License-Identifier: Apache-2.0
#include "quality/offenders.h"

#include <algorithm>
#include <numeric>

#include "core/parallel.h"
#include "elliptic/fold_count.h"
#include "quality/cell_corners.h"
#include "quality/cell_measures.h"

namespace hexweave {

namespace {

constexpr std::size_t most_marked = 10;

std::size_t cell_offset(const Node& cell, const Extent& e) {
    const auto [i, j, k] = cell;
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(e.ni - 1) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(e.nj - 1) * static_cast<std::size_t>(k));
}

/// The least of a cell's corners.
double least_corner(const PointField& x, const Node& cell, const Vec3& plane) {
    double least = 1;
    for (const CellCorner& corner : cell_corners(x, cell, plane)) {
        if (!corner.counted_apart()) least = std::min(least, corner.scaled_jacobian);
    }
    return least;
}

std::vector<double> scaled_jacobians(const PointField& x) {
    const Extent e = x.extent();
    const Vec3 plane = e.nk == 1 ? plane_normal(x) : Vec3{};
    std::vector<double> values(e.cells());
    const auto rows = static_cast<std::size_t>((e.nj - 1) * std::max(e.nk - 1, 1));
    parallel_for(rows, [&](std::size_t row) {
        const int j = static_cast<int>(row) % (e.nj - 1);
        const int k = static_cast<int>(row) / (e.nj - 1);
        for (int i = 0; i + 1 < e.ni; ++i) {
            values[cell_offset({i, j, k}, e)] = least_corner(x, {i, j, k}, plane);
        }
    });
    return values;
}

}  // namespace

CellMarks mark_cells(const PointField& points) {
    CellMarks marks;
    marks.scaled_jacobian = scaled_jacobians(points);
    const std::size_t cells = marks.scaled_jacobian.size();
    marks.folded.assign(cells, 0);
    for (const FoldedCell& found : folded_cells(points)) {
        marks.folded[cell_offset(found.cell, points.extent())] = 1;
    }
    std::vector<std::size_t> order(cells);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto marked = order.begin() + static_cast<std::ptrdiff_t>(std::min(cells, most_marked));
    std::partial_sort(order.begin(), marked, order.end(), [&](std::size_t a, std::size_t b) {
        if (marks.folded[a] != marks.folded[b]) return marks.folded[a] > marks.folded[b];
        const double value_a = marks.scaled_jacobian[a];
        const double value_b = marks.scaled_jacobian[b];
        return value_a != value_b ? value_a < value_b : a < b;
    });
    marks.worst.assign(cells, 0);
    double rank = 0;
    for (auto cell = order.begin(); cell != marked; ++cell) marks.worst[*cell] = ++rank;
    return marks;
}

namespace {

/// Whether a face or block is a zone with folded cells: at a level of a nested family it may be,
/// though that of the solved level is not.
bool is_folded_zone(const Report& report, const std::string& name) {
    return std::any_of(report.zones.begin(), report.zones.end(), [&](const ZoneMeasure& zone) {
        return zone.name == name && zone.folded > 0;
    });
}

}  // namespace

std::vector<Offender> find_offenders(const Report& report, const std::vector<FaceGrid>& faces,
                                     const std::vector<BlockGrid>& blocks) {
    std::vector<Offender> found;
    for (std::size_t n = 0; n < report.solves.size(); ++n) {
        const SolveMeasure& solve = report.solves[n];
        const bool is_zone = solve.is_block == report.solves.back().is_block;
        if (solve.ended_well() && !(is_zone && is_folded_zone(report, solve.name))) continue;
        const PointField& points =
            solve.is_block ? blocks[n - faces.size()].points : faces[n].points;
        found.push_back({solve.name, solve.is_block, points, mark_cells(points)});
    }
    return found;
}

}  // namespace hexweave
