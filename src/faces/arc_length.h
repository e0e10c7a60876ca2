// SPDX-License-Identifier: Apache-2.0
// Normalized arc length of grid points along a line: what the algebraic maps are built from.
#pragma once

#include <vector>

#include "core/field.h"

namespace hexweave {

/// The points of the grid line through `start` along `axis` (0, 1 or 2), in index order.
std::vector<Vec3> grid_line(const PointField& points, std::array<int, 3> start, int axis);

/// Whether the points of a line differ: those of a pole do not.
bool has_length(const std::vector<Vec3>& line);

/// The length of the polygon up to each of its points, over its whole length: exactly 0 at the
/// first and exactly 1 at the last, never decreasing. The line must have a length.
/// [Spekreijse & Boerstoel 1996, eqs. (30)-(34), (37), (38)]
std::vector<double> normalized_arc_length(const std::vector<Vec3>& line);

}  // namespace hexweave
