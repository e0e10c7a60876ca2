// SPDX-License-Identifier: Apache-2.0
#include "quality/cell_measures.h"

#include <array>
#include <limits>

namespace hexweave {

namespace {

/// The edges of a cell, as pairs of corners: along i, j, k.
struct EdgesOfCell {
    std::array<std::array<std::size_t, 2>, 12> pairs{};
    std::size_t count = 0;

    explicit EdgesOfCell(std::size_t axes) {
        for (std::size_t axis = 0; axis < axes; ++axis) {
            const std::size_t bit = std::size_t{1} << axis;
            for (std::size_t low = 0; low < (std::size_t{1} << axes); ++low) {
                if ((low & bit) == 0) pairs[count++] = {low, low | bit};
            }
        }
    }
};

}  // namespace

CellNodes cell_nodes(const PointField& x, const Node& cell) {
    CellNodes nodes{};
    const int corners = x.extent().nk == 1 ? 4 : 8;
    for (int c = 0; c < corners; ++c) {
        nodes[static_cast<std::size_t>(c)] =
            x(cell[0] + (c & 1), cell[1] + ((c >> 1) & 1), cell[2] + (c >> 2));
    }
    return nodes;
}

double cell_aspect_ratio(const CellNodes& nodes, std::size_t axes) {
    double shortest = std::numeric_limits<double>::infinity();
    double longest = 0;
    const EdgesOfCell edges(axes);
    for (std::size_t n = 0; n < edges.count; ++n) {
        const double length = distance(nodes[edges.pairs[n][0]], nodes[edges.pairs[n][1]]);
        if (length == 0) continue;
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
    }
    return longest > 0 ? longest / shortest : 1;
}

double surface_cell_area(const CellNodes& n, const Vec3& plane) {
    const Vec3 area = 0.5 * cross(n[3] - n[0], n[2] - n[1]);
    return plane == Vec3{} ? norm(area) : dot(area, plane);
}

CellMeasures measure_cell(const PointField& x, const Node& cell, const Vec3& plane) {
    const std::size_t axes = x.extent().nk == 1 ? 2 : 3;
    const CellNodes nodes = cell_nodes(x, cell);
    CellMeasures measures;
    for (const CellCorner& corner : cell_corners(x, cell, plane)) {
        if (corner.counted_apart()) continue;
        if (!(corner.scaled_jacobian >= measures.scaled_jacobian)) {
            measures.scaled_jacobian = corner.scaled_jacobian;
        }
    }
    visit_deviations(nodes, axes, [&measures](double off) {
        if (!(off / 90 <= measures.skewness)) measures.skewness = off / 90;
    });
    measures.aspect_ratio = cell_aspect_ratio(nodes, axes);
    measures.volume =
        axes == 3 ? cell_volume(jacobian_coefficients(nodes)) : surface_cell_area(nodes, plane);
    return measures;
}

}  // namespace hexweave
