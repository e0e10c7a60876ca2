// SPDX-License-Identifier: Apache-2.0
// What a report shows of a grid: sheets of nodes, thinned where a page could not hold all of them.
// The boundaries, index planes of every zone, and small sheets through the worst cells; of a planar
// or surface grid the zones themselves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/multiblock.h"
#include "io/picture.h"
#include "quality/grid_quality.h"

namespace hexweave {

/// A rectangle of nodes of one zone, one axis constant (k in a surface grid).
struct ReportSheet {
    int zone = 0;
    int axis = 2;     ///< that is constant
    int index = 0;    ///< along it, zero-based
    int family = -1;  ///< of a boundary; -1: an index plane, or a zone of a surface grid
    int worst = -1;   ///< beside the worst cell of that rank; -1: not one of these
    IndexBox box;     ///< runs forwards
    int stride = 1;   ///< every so many lines are in the page, and the last
    std::array<std::vector<int>, 2> lines;  ///< node indices along the running axes, ascending
};

/// How many bytes the sheets of a page may take as text, and how index planes are chosen.
struct SheetBudget {
    std::size_t bytes = 6'000'000;
    int planes_per_axis = 9;  ///< at most, evenly spaced from the first to the last
};

/// All sheets of a page. `planes` are wanted besides those chosen. Where the budget is exceeded
/// there are fewer planes along each axis, then every second, fourth, ... line of every sheet; the
/// sheets beside the worst cells and the planes that were asked for stay whole. Throws UsageError
/// for a plane that the grid does not have.
std::vector<ReportSheet> report_sheets(const MultiblockGrid& grid,
                                       const std::vector<IndexPlane>& planes,
                                       const std::vector<WorstCell>& worst,
                                       const SheetBudget& budget = {});

/// The bytes of a sheet as text: coordinates and measures.
std::size_t sheet_bytes(const ReportSheet& sheet);

/// x, y, z of every node in single precision, little endian; the first running axis fastest.
std::vector<std::uint8_t> sheet_coordinates(const MultiblockGrid& grid, const ReportSheet& sheet);

/// Four bytes for every cell of the sheet, the worst of the grid's cells on either side of it that
/// it covers: scaled Jacobian (0: not positive, 1 to 255: up to 1), equiangle skewness (0 to 1),
/// decimal logarithm of the aspect ratio (0 to 6), 255 where a cell is folded and 0 else.
std::vector<std::uint8_t> sheet_measures(const MultiblockGrid& grid, const ReportSheet& sheet);

}  // namespace hexweave
