// SPDX-License-Identifier: Apache-2.0
// How far the nodes of a level moved, in cells.
#pragma once

#include "elliptic/level.h"

namespace hexweave {

/// The largest of |a^1.d|, |a^2.d| and |a^3.d| over the interior nodes for the displacements d:
/// along the contravariant base vectors of the present points, index spacing 1. On a face a^1 and
/// a^2 lie in the tangent plane, and what leaves it counts against the square root of the cell's
/// area. Cells whose base vectors come nearer to one plane (line) than about one degree are taken
/// as if they stood that far apart. NaN when any number is.
double largest_displacement(const Level& level, const RowArray<float>& displacements);

}  // namespace hexweave
