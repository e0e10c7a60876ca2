// SPDX-License-Identifier: Apache-2.0
// Whether a grid is the same as a golden one, and where it is not.
#pragma once

#include <string>
#include <vector>

#include "quality/outline_comparison.h"
#include "quality/point_deviation.h"
#include "quality/point_source.h"
#include "quality/zone_match.h"

namespace hexweave {

struct ComparisonOptions {
    double tolerance = 1e-4;  ///< of the local cell
    bool by_shape = false;    ///< zones are matched by their shape, not by their names
};

/// The points of two zones that were matched and have the same numbers of nodes.
struct ZoneComparison {
    std::string name;
    std::string golden_name;
    Extent extent;
    Orientation to_golden;
    ZoneDeviation deviation;
};

struct GridComparison {
    double tolerance = 1e-4;
    double floor = 0;  ///< the length up to which no deviation counts
    std::string units;
    int cell_dimension = 3;
    std::vector<ZoneComparison> zones;
    std::vector<Difference> differences;  ///< other than points
    std::vector<OtherNodes> others;       ///< of the candidate: not compared
    std::vector<OtherNodes> golden_others;

    /// All zones together.
    ZoneDeviation all() const;
    bool same() const;
};

/// Compares everything. A coordinate of the candidate that is no finite number differs from
/// everything; one of the golden grid makes a comparison impossible, for it has no cell to measure
/// in: throws UsageError. So does a golden grid with an interface that contradicts itself. The same
/// result for any number of threads and any size of the pieces.
GridComparison compare_grids(const PointSource& candidate, const PointSource& golden,
                             const ComparisonOptions& options);

}  // namespace hexweave
