// SPDX-License-Identifier: Apache-2.0
// Families of grids as they are printed.
#pragma once

#include <string>
#include <vector>

#include "quality/report.h"

namespace hexweave {

/// "level coarse of coarse, medium, fine, factor 2: every 4th point of level fine, which is
/// solved", and the end of the line.
std::string level_line(const LevelMeasure& level);

/// A line per level: cells, by how much a line of the grid has more of them than at the level
/// before, the greatest growth of neighbouring cells along lines and across interfaces, the worst
/// corner, the median height of first cells at walls.
std::string family_table(const std::vector<Report>& reports);

}  // namespace hexweave
