// SPDX-License-Identifier: Apache-2.0
// What is kept of a solve that does not converge: the best of all its grids, not the last.
#pragma once

#include <compare>
#include <limits>

#include "core/field.h"

namespace hexweave {

/// By what one grid of a solve is better than another: fewer folded cells, then a smaller
/// displacement. A displacement that is no number makes a grid no better than any.
struct IterateRank {
    long folded = 0;
    double displacement = std::numeric_limits<double>::infinity();  ///< in cells

    friend auto operator<=>(const IterateRank&, const IterateRank&) = default;
};

/// The best of the grids that it was offered, the start grid among them.
struct BestIterate {
    PointField points;
    IterateRank rank;
    int cycle = 0;  ///< that gave it, counted from 1; 0: the start grid

    /// Of the start grid no displacement is known: any grid with as few folded cells is better.
    explicit BestIterate(const PointField& start);

    void offer(const PointField& grid, double displacement, int after_cycle);
};

}  // namespace hexweave
