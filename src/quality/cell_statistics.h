// SPDX-License-Identifier: Apache-2.0
// What the cells of a zone have in common: extremes, means and histograms over all of them.
#pragma once

#include <cstddef>
#include <vector>

#include "core/multiblock.h"
#include "quality/grid_quality.h"
#include "quality/histogram.h"

namespace hexweave {

/// Fine enough for quantiles of the equiangle skewness.
Histogram skewness_in_thousandths();

struct CellStatistics {
    ZoneQuality quality;  ///< all but `measure` and `bends`
    Histogram scaled_jacobian{
        "scaled Jacobian", {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}, true};
    Histogram skewness = skewness_in_thousandths();
    Histogram aspect_ratio{"aspect ratio", {2, 5, 10, 100, 1e3, 1e4, 1e5, 1e6}};
    Histogram deviation{"degrees from 90", {5, 10, 20, 30, 40, 50, 60, 70, 80}};
    std::vector<WorstCell> worst;  ///< worst first
};

/// Over the cells of one zone; surface cells are measured against zone_plane.
CellStatistics cell_statistics(const Zone& zone, int physical_dimension, int worst_count);

}  // namespace hexweave
