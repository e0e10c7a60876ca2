// SPDX-License-Identifier: Apache-2.0
#include "quality/point_deviation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "core/errors.h"
#include "core/parallel.h"

namespace hexweave {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A grid line of the golden piece inside the core, and where the candidate's nodes lie.
struct Row {
    std::size_t golden = 0;     ///< the place of its first node
    std::size_t candidate = 0;  ///< ... among the candidate's values
    std::ptrdiff_t step = 1;    ///< from one node of the candidate to the next
    Node node{};                ///< the first node, of the golden zone
};

/// One comparison: everything that all its rows share.
struct Work {
    const Portion& portion;
    const Piece& golden;
    const Piece& candidate;
    const Orientation& to_candidate;
    const Extent& candidate_extent;
    const Allowance& allowed;
};

/// Squares along a row, kept between rows.
struct Buffers {
    std::vector<double> deviation;
    std::vector<double> edge;
};

/// Squared, scaled distances of the candidate's points; whether any is not zero.
bool measure_deviations(const Work& work, const Row& row, std::vector<double>& squares) {
    const double scale = work.allowed.scale;
    const std::size_t count = squares.size();
    std::fill(squares.begin(), squares.end(), 0.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double* golden = work.golden.values[axis] + row.golden;
        const double* candidate = work.candidate.values[axis] + row.candidate;
        for (std::size_t n = 0; n < count; ++n) {
            const double d =
                (candidate[static_cast<std::ptrdiff_t>(n) * row.step] - golden[n]) * scale;
            squares[n] += d * d;
        }
    }
    return std::any_of(squares.begin(), squares.end(), [](double s) { return !(s == 0); });
}

/// Shortens `squares` to the squared lengths of the edges from nodes [first, last) of the row to
/// the nodes `step` farther.
void shorten(const Work& work, const Row& row, std::size_t first, std::size_t last,
             std::ptrdiff_t step, std::vector<double>& squares) {
    const double scale = work.allowed.scale;
    const double shortest = work.allowed.floor * scale * work.allowed.floor * scale;
    const double* x = work.golden.values[0] + row.golden;
    const double* y = work.golden.values[1] + row.golden;
    const double* z = work.golden.values[2] + row.golden;
    for (std::size_t n = first; n < last; ++n) {
        const auto here = static_cast<std::ptrdiff_t>(n);
        const double dx = (x[here + step] - x[here]) * scale;
        const double dy = (y[here + step] - y[here]) * scale;
        const double dz = (z[here + step] - z[here]) * scale;
        const double square = dx * dx + dy * dy + dz * dz;
        squares[n] = square > shortest ? std::min(squares[n], square) : squares[n];
    }
}

/// Squared, scaled sizes of the local cells along a row; infinite where no edge has a length.
void measure_cells(const Work& work, const Row& row, std::vector<double>& squares) {
    const IndexBox& box = work.golden.box;
    const Extent extent = work.golden.extent();
    const std::size_t count = squares.size();
    const std::array<std::ptrdiff_t, 3> steps{1, extent.ni,
                                              static_cast<std::ptrdiff_t>(extent.ni) * extent.nj};
    std::fill(squares.begin(), squares.end(), infinity);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int begin = row.node[axis];
        const int end = axis == 0 ? begin + static_cast<int>(count) - 1 : begin;
        const std::size_t skipped = axis == 0 && begin == box.begin[0] ? 1 : 0;
        const std::size_t cut_off = axis == 0 && end == box.end[0] ? 1 : 0;
        if (axis == 0 || begin > box.begin[axis]) {
            shorten(work, row, skipped, count, -steps[axis], squares);
        }
        if (axis == 0 || end < box.end[axis]) {
            shorten(work, row, 0, count - cut_off, steps[axis], squares);
        }
    }
}

Deviation deviation_at(const Work& work, const Row& row, std::size_t n, double size) {
    Node node = row.node;
    node[0] += static_cast<int>(n);
    return {size, map_node(work.to_candidate, node, work.candidate_extent),
            work.golden.at(row.golden + n)};
}

/// Adds a row to what is known. Deviations are the squares of what they will be, until `settle`.
void compare_row(const Work& work, const Row& row, Buffers& buffers, ZoneDeviation& found) {
    if (!measure_deviations(work, row, buffers.deviation)) return;
    measure_cells(work, row, buffers.edge);
    const double tolerance = work.allowed.tolerance * work.allowed.tolerance;
    const double floor = work.allowed.floor * work.allowed.scale;
    for (std::size_t n = 0; n < buffers.deviation.size(); ++n) {
        double square = buffers.deviation[n];
        if (square == 0) continue;
        if (std::isnan(square)) square = infinity;
        const double cell = buffers.edge[n] == infinity ? floor * floor : buffers.edge[n];
        const double in_cells = square / cell;
        // However small or large the tolerance: the floor is allowed, what is no number is not.
        const bool is_beyond =
            square == infinity || square > std::max(floor * floor, tolerance * cell);
        found.beyond += is_beyond ? 1 : 0;
        if (square == infinity) {
            const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(row.candidate) +
                                      static_cast<std::ptrdiff_t>(n) * row.step;
            if (!is_finite(work.candidate.at(static_cast<std::size_t>(at)))) ++found.not_finite;
        }
        if (in_cells > found.in_cells.size) found.in_cells = deviation_at(work, row, n, in_cells);
        if (square > found.in_length.size) found.in_length = deviation_at(work, row, n, square);
    }
}

/// The row of the core that begins at golden node `node`.
Row row_at(const Work& work, const Node& node) {
    const Node own = map_node(work.to_candidate, node, work.candidate_extent);
    const Extent extent = work.candidate.extent();
    const std::array<std::ptrdiff_t, 3> steps{1, extent.ni,
                                              static_cast<std::ptrdiff_t>(extent.ni) * extent.nj};
    const int along = work.to_candidate.axes[0];
    const std::ptrdiff_t step = steps[static_cast<std::size_t>(std::abs(along) - 1)];
    return {work.golden.offset(node), work.candidate.offset(own), along > 0 ? step : -step, node};
}

ZoneDeviation settle(ZoneDeviation found, const Allowance& allowed) {
    found.in_cells.size = std::sqrt(found.in_cells.size);
    found.in_length.size = std::sqrt(found.in_length.size) / allowed.scale;
    return found;
}

}  // namespace

Allowance allowance(double tolerance, const PointBox& golden) {
    const Vec3 size = golden.greatest - golden.least;
    const double diagonal = std::hypot(size.x, size.y, size.z);
    if (!std::isfinite(diagonal)) {
        throw UsageError("cannot compare: the coordinates are too large for double precision");
    }
    // A power of two that is near the size, so that no square overflows or vanishes.
    constexpr int farthest = 1000;
    const int exponent = diagonal > 0 ? std::clamp(std::ilogb(diagonal), -farthest, farthest) : 0;
    return {tolerance, 4 * std::numeric_limits<double>::epsilon() * diagonal,
            std::ldexp(1.0, -exponent)};
}

ZoneDeviation together(const ZoneDeviation& first, const ZoneDeviation& second) {
    ZoneDeviation both = first;
    both.points += second.points;
    both.beyond += second.beyond;
    both.not_finite += second.not_finite;
    if (second.in_cells.size > both.in_cells.size) both.in_cells = second.in_cells;
    if (second.in_length.size > both.in_length.size) both.in_length = second.in_length;
    return both;
}

ZoneDeviation compare_points(const Portion& portion, const Piece& golden, const Piece& candidate,
                             const Orientation& to_candidate, const Extent& candidate_extent,
                             const Allowance& allowed) {
    const Work work{portion, golden, candidate, to_candidate, candidate_extent, allowed};
    const IndexBox& core = portion.core;
    const auto length = [&core](std::size_t axis) {
        return static_cast<std::size_t>(core.end[axis] - core.begin[axis]) + 1;
    };
    const std::size_t rows = length(1) * length(2);
    // A fixed number of parts, put together in order: the same result for any number of threads.
    const std::size_t parts = std::min<std::size_t>(rows, 16);
    std::vector<ZoneDeviation> found(parts);
    parallel_for(parts, [&](std::size_t part) {
        Buffers buffers{std::vector<double>(length(0)), std::vector<double>(length(0))};
        for (std::size_t row = rows * part / parts; row < rows * (part + 1) / parts; ++row) {
            const Node node{core.begin[0], core.begin[1] + static_cast<int>(row % length(1)),
                            core.begin[2] + static_cast<int>(row / length(1))};
            compare_row(work, row_at(work, node), buffers, found[part]);
        }
    });
    ZoneDeviation all;
    for (const ZoneDeviation& part : found) all = together(all, part);
    all.points = rows * length(0);
    return settle(all, allowed);
}

}  // namespace hexweave
