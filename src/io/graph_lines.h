// SPDX-License-Identifier: Apache-2.0
// Lines of drawings that tell what is joined to what: between the boxes of a graph, and broken
// ones, which mean periodic everywhere.
#pragma once

#include <vector>

#include "io/picture_drawing.h"

namespace hexweave {

/// Of periodic pairs.
inline constexpr Colour periodic_colour{0.5, 0.2, 0.55};

/// From a box to another: straight for the first line between the two, bent a little more for each
/// `earlier` one. A loop above the box where it is joined to itself.
Polyline link_line(const PagePoint& a, const PagePoint& b, int earlier);

/// The line in pieces with gaps between.
std::vector<Polyline> dashes(const Polyline& line);

}  // namespace hexweave
