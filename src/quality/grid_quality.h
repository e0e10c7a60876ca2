// SPDX-License-Identifier: Apache-2.0
// The quality of any structured grid, whoever made it: what `hexweave quality` tells.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/multiblock.h"
#include "quality/histogram.h"
#include "quality/jacobian_bound.h"
#include "quality/report.h"
#include "quality/smoothness.h"
#include "quality/walls.h"

namespace hexweave {

/// A greatest (or least) value of the cells of a zone, and the cell that has it.
struct CellExtreme {
    double value = 0;
    Node cell{};
    Vec3 place;  ///< the mean of the cell's nodes
};

struct ZoneQuality {
    ZoneMeasure measure;  ///< corners, angles and growth, as in the report of a run
    /// Of a block's cells the integral of the Jacobian of their trilinear maps; of a surface's half
    /// the product of the diagonals. The whole, the least and the greatest.
    double volume = 0;
    CellExtreme least_volume;
    CellExtreme greatest_volume;
    CellExtreme least_jacobian;  ///< over the corners of all cells
    /// Cells whose Jacobian is positive everywhere, proven; not positive somewhere, proven; too
    /// near to zero to tell. Flat corners and poles excepted.
    std::size_t positive = 0;
    std::size_t not_positive = 0;
    std::size_t undecided = 0;
    /// Equiangle skewness of a cell: the greatest of |angle - 90| / 90 over its angles.
    CellExtreme greatest_skewness;
    double mean_skewness = 0;
    double skewness_99 = 0;  ///< that 99 % of the cells do not exceed, to a thousandth
    /// The longest over the shortest edge of a cell (edges without length do not count).
    CellExtreme greatest_aspect_ratio;
    std::array<BendMeasure, 3> bends;  ///< along i, j and k
};

struct InterfaceQuality {
    InterfaceMeasure measure;
    BendMeasure bends;
};

/// A cell among the worst: those whose Jacobian is not positive somewhere before all others, then
/// by the least scaled Jacobian of their corners.
struct WorstCell {
    std::string zone;
    Node cell{};
    Vec3 place;
    double scaled_jacobian = 1;
    double volume = 0;
    double skewness = 0;
    JacobianVerdict verdict = JacobianVerdict::positive;
};

bool is_worse(const WorstCell& a, const WorstCell& b);

struct GridQuality {
    std::string title;
    std::string units;
    std::vector<ZoneQuality> zones;
    std::vector<InterfaceQuality> interfaces;
    std::vector<WallMeasure> boundaries;
    std::vector<Histogram> histograms;
    std::vector<WorstCell> worst;

    std::size_t cells() const;
    std::size_t folded() const;
    std::size_t not_positive() const;
    std::size_t undecided() const;
    std::size_t mismatched() const;
    /// No folded cell, none whose Jacobian is not positive somewhere, every interface the same on
    /// both sides.
    bool sound() const;
};

/// A grid that names no boundary gets a family for every side of every zone, `ZONE:imin` and so on,
/// so that there is something to tell of them.
void name_sides_where_nothing_is_named(MultiblockGrid& grid);

/// All measures; the `worst_count` worst cells. Zones one after the other, their layers in
/// parallel; the same for any number of threads.
GridQuality measure_quality(const MultiblockGrid& grid, int worst_count = 10);

}  // namespace hexweave
