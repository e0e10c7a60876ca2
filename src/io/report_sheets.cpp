// SPDX-License-Identifier: Apache-2.0
#include "io/report_sheets.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "io/grid_names.h"
#include "quality/cell_corners.h"
#include "quality/cell_measures.h"

namespace hexweave {

namespace {

constexpr int cells_beside_worst = 6;  ///< on either side of it, in the sheets through it

const Extent& extent_of(const MultiblockGrid& grid, int zone) {
    return grid.zones[static_cast<std::size_t>(zone)].points.extent();
}

std::array<std::size_t, 2> running_axes(int constant) {
    if (constant == 0) return {1, 2};
    if (constant == 1) return {0, 2};
    return {0, 1};
}

IndexBox plane_box(const Extent& extent, int axis, int index) {
    IndexBox box{{0, 0, 0}, {extent.ni - 1, extent.nj - 1, extent.nk - 1}};
    box.begin[static_cast<std::size_t>(axis)] = index;
    box.end[static_cast<std::size_t>(axis)] = index;
    return box;
}

/// Every `stride`-th line of the box, and the last.
void thin(ReportSheet& sheet, int stride) {
    sheet.stride = stride;
    const auto axes = running_axes(sheet.axis);
    for (std::size_t a = 0; a < 2; ++a) {
        const int begin = sheet.box.begin[axes[a]];
        const int end = sheet.box.end[axes[a]];
        sheet.lines[a].clear();
        for (int n = begin; n < end; n += stride) sheet.lines[a].push_back(n);
        sheet.lines[a].push_back(end);
    }
}

ReportSheet make_sheet(int zone, int axis, const IndexBox& box) {
    ReportSheet sheet;
    sheet.zone = zone;
    sheet.axis = axis;
    sheet.index = box.begin[static_cast<std::size_t>(axis)];
    sheet.box = box;
    thin(sheet, 1);
    return sheet;
}

/// The axis along which a patch is one node thick; of a patch that is a line or a point, none.
int constant_axis(const IndexBox& box) {
    int constant = -1;
    for (std::size_t a = 0; a < 3; ++a) {
        if (box.begin[a] != box.end[a]) continue;
        if (constant >= 0) return -1;
        constant = static_cast<int>(a);
    }
    return constant;
}

IndexBox forwards(IndexBox box) {
    for (std::size_t a = 0; a < 3; ++a) {
        if (box.begin[a] > box.end[a]) std::swap(box.begin[a], box.end[a]);
    }
    return box;
}

std::vector<ReportSheet> boundary_sheets(const MultiblockGrid& grid) {
    std::vector<ReportSheet> sheets;
    if (grid.cell_dimension == 2) {
        for (int zone = 0; zone < static_cast<int>(grid.zones.size()); ++zone) {
            sheets.push_back(make_sheet(zone, 2, plane_box(extent_of(grid, zone), 2, 0)));
        }
        return sheets;
    }
    for (const BoundaryPatch& patch : grid.patches) {
        const IndexBox box = forwards(patch.box);
        const int axis = constant_axis(box);
        if (axis < 0) continue;
        sheets.push_back(make_sheet(patch.zone, axis, box));
        sheets.back().family = patch.family;
    }
    return sheets;
}

/// `count` indices from 0 to `last`, evenly spaced, each once.
std::vector<int> spread(int last, int count) {
    if (count == 1) return {last / 2};
    std::vector<int> indices;
    for (int n = 0; n < count; ++n) {
        const int index =
            static_cast<int>(std::lround(static_cast<double>(last) * n / (count - 1)));
        if (indices.empty() || indices.back() != index) indices.push_back(index);
    }
    return indices;
}

std::vector<ReportSheet> spread_planes(const MultiblockGrid& grid, int per_axis) {
    std::vector<ReportSheet> sheets;
    if (grid.cell_dimension == 2) return sheets;
    for (int zone = 0; zone < static_cast<int>(grid.zones.size()); ++zone) {
        const Extent& extent = extent_of(grid, zone);
        for (int axis = 0; axis < 3; ++axis) {
            for (const int index : spread(extent[axis] - 1, per_axis)) {
                sheets.push_back(make_sheet(zone, axis, plane_box(extent, axis, index)));
            }
        }
    }
    return sheets;
}

std::vector<ReportSheet> asked_planes(const MultiblockGrid& grid,
                                      const std::vector<IndexPlane>& planes) {
    std::vector<ReportSheet> sheets;
    for (const IndexPlane& plane : planes) {
        for (const int zone : zones_of_plane(grid, plane)) {
            const Extent& extent = extent_of(grid, zone);
            sheets.push_back(
                make_sheet(zone, plane.axis, plane_box(extent, plane.axis, plane.index)));
        }
    }
    return sheets;
}

/// The planes through the low corner of each of the worst cells, as far as a few cells from it.
std::vector<ReportSheet> worst_sheets(const MultiblockGrid& grid,
                                      const std::vector<WorstCell>& worst) {
    std::vector<ReportSheet> sheets;
    if (grid.cell_dimension == 2) return sheets;
    for (std::size_t rank = 0; rank < worst.size(); ++rank) {
        const auto zone = static_cast<int>(
            std::find_if(grid.zones.begin(), grid.zones.end(),
                         [&](const Zone& z) { return z.name == worst[rank].zone; }) -
            grid.zones.begin());
        for (int axis = 0; axis < 3; ++axis) {
            const Node& cell = worst[rank].cell;
            IndexBox box =
                plane_box(extent_of(grid, zone), axis, cell[static_cast<std::size_t>(axis)]);
            for (const std::size_t a : running_axes(axis)) {
                box.begin[a] = std::max(box.begin[a], cell[a] - cells_beside_worst);
                box.end[a] = std::min(box.end[a], cell[a] + 1 + cells_beside_worst);
            }
            sheets.push_back(make_sheet(zone, axis, box));
            sheets.back().worst = static_cast<int>(rank);
        }
    }
    return sheets;
}

std::size_t total_bytes(const std::vector<ReportSheet>& sheets) {
    std::size_t sum = 0;
    for (const ReportSheet& sheet : sheets) sum += sheet_bytes(sheet);
    return sum;
}

/// As many planes along each axis as there is room for, thinned where even one is too much.
std::vector<ReportSheet> planes_within(const MultiblockGrid& grid, std::size_t room,
                                       int planes_per_axis) {
    std::vector<ReportSheet> planes;
    for (int count = planes_per_axis; count >= 1; count -= 2) {
        planes = spread_planes(grid, count);
        if (total_bytes(planes) <= room) return planes;
    }
    for (int stride = 2; total_bytes(planes) > room && stride <= 1024; stride *= 2) {
        for (ReportSheet& sheet : planes) thin(sheet, stride);
    }
    return planes;
}

/// What a cell of the sheet shows of the grid's cells that it covers.
struct ShownMeasures {
    double scaled_jacobian = 1;
    double skewness = 0;
    double aspect_ratio = 1;
    bool folded = false;

    void include(const PointField& points, const Node& cell, const Vec3& plane) {
        const CellMeasures m = measure_cell(points, cell, plane);
        // NaN is the worst of all values.
        if (!(m.scaled_jacobian >= scaled_jacobian)) scaled_jacobian = m.scaled_jacobian;
        if (!(m.skewness <= skewness)) skewness = m.skewness;
        if (!(m.aspect_ratio <= aspect_ratio)) aspect_ratio = m.aspect_ratio;
        const CellCorners corners = cell_corners(points, cell, plane);
        folded = folded || std::any_of(corners.begin(), corners.end(),
                                       [](const CellCorner& c) { return c.folds(); });
    }
};

/// A byte for a value from 0 to `most`; what is not finite becomes `bad`.
std::uint8_t to_byte(double value, double most, std::uint8_t bad) {
    if (!std::isfinite(value)) return bad;
    return static_cast<std::uint8_t>(std::lround(std::clamp(value / most, 0.0, 1.0) * 255));
}

void append(std::vector<std::uint8_t>& bytes, const ShownMeasures& m) {
    const std::uint8_t jacobian = to_byte(m.scaled_jacobian, 1, 0);
    bytes.push_back(m.scaled_jacobian > 0 ? std::max<std::uint8_t>(jacobian, 1) : jacobian);
    bytes.push_back(to_byte(m.skewness, 1, 255));
    bytes.push_back(to_byte(std::log10(m.aspect_ratio), 6, 255));
    bytes.push_back(m.folded ? 255 : 0);
}

/// Indices of the layers of cells on either side of the sheet.
std::vector<int> layers_beside(const ReportSheet& sheet, const Extent& extent) {
    if (extent[sheet.axis] == 1) return {0};
    std::vector<int> layers;
    if (sheet.index > 0) layers.push_back(sheet.index - 1);
    if (sheet.index < extent[sheet.axis] - 1) layers.push_back(sheet.index);
    return layers;
}

ShownMeasures measures_between(const PointField& points, const Vec3& plane,
                               const ReportSheet& sheet, std::size_t first, std::size_t second) {
    const auto axes = running_axes(sheet.axis);
    ShownMeasures shown;
    for (const int layer : layers_beside(sheet, points.extent())) {
        for (int n = sheet.lines[1][second]; n < sheet.lines[1][second + 1]; ++n) {
            for (int m = sheet.lines[0][first]; m < sheet.lines[0][first + 1]; ++m) {
                Node cell{};
                cell[static_cast<std::size_t>(sheet.axis)] = layer;
                cell[axes[0]] = m;
                cell[axes[1]] = n;
                shown.include(points, cell, plane);
            }
        }
    }
    return shown;
}

}  // namespace

std::size_t sheet_bytes(const ReportSheet& sheet) {
    const std::size_t first = sheet.lines[0].size();
    const std::size_t second = sheet.lines[1].size();
    return (first * second * 12 + (first - 1) * (second - 1) * 4) * 4 / 3 + 200;
}

std::vector<ReportSheet> report_sheets(const MultiblockGrid& grid,
                                       const std::vector<IndexPlane>& planes,
                                       const std::vector<WorstCell>& worst,
                                       const SheetBudget& budget) {
    std::vector<ReportSheet> sheets = boundary_sheets(grid);
    // Index planes get what the boundaries leave, and half of the budget at least.
    const std::size_t boundary_room = grid.cell_dimension == 2 ? budget.bytes : budget.bytes / 2;
    for (int stride = 2; total_bytes(sheets) > boundary_room && stride <= 1024; stride *= 2) {
        for (ReportSheet& sheet : sheets) thin(sheet, stride);
    }
    const auto add = [&sheets](std::vector<ReportSheet> more) {
        sheets.insert(sheets.end(), std::make_move_iterator(more.begin()),
                      std::make_move_iterator(more.end()));
    };
    const std::size_t used = total_bytes(sheets);
    add(planes_within(grid, budget.bytes - std::min(used, budget.bytes / 2),
                      budget.planes_per_axis));
    add(asked_planes(grid, planes));
    add(worst_sheets(grid, worst));
    return sheets;
}

std::vector<std::uint8_t> sheet_coordinates(const MultiblockGrid& grid, const ReportSheet& sheet) {
    const PointField& points = grid.zones[static_cast<std::size_t>(sheet.zone)].points;
    const auto axes = running_axes(sheet.axis);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(sheet.lines[0].size() * sheet.lines[1].size() * 12);
    Node node{};
    node[static_cast<std::size_t>(sheet.axis)] = sheet.index;
    for (const int n : sheet.lines[1]) {
        node[axes[1]] = n;
        for (const int m : sheet.lines[0]) {
            node[axes[0]] = m;
            const Vec3 p = points(node[0], node[1], node[2]);
            for (const double component : {p.x, p.y, p.z}) {
                const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(component));
                for (int shift = 0; shift < 32; shift += 8) {
                    bytes.push_back(static_cast<std::uint8_t>(bits >> shift & 0xFFU));
                }
            }
        }
    }
    return bytes;
}

std::vector<std::uint8_t> sheet_measures(const MultiblockGrid& grid, const ReportSheet& sheet) {
    const PointField& points = grid.zones[static_cast<std::size_t>(sheet.zone)].points;
    const Vec3 plane = zone_plane(points, grid.physical_dimension);
    std::vector<std::uint8_t> bytes;
    for (std::size_t second = 0; second + 1 < sheet.lines[1].size(); ++second) {
        for (std::size_t first = 0; first + 1 < sheet.lines[0].size(); ++first) {
            append(bytes, measures_between(points, plane, sheet, first, second));
        }
    }
    return bytes;
}

}  // namespace hexweave
