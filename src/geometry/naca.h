// SPDX-License-Identifier: Apache-2.0
// NACA airfoils of four digits, from their formula.
#pragma once

#include <string_view>

#include "geometry/curve.h"
#include "geometry/curve_result.h"

namespace hexweave {

/// Which part of an airfoil. `upper` and `lower` run from the leading edge to the trailing edge;
/// `whole` runs from the trailing edge along the upper side over the leading edge and back along
/// the lower side.
enum class AirfoilSide { upper, lower, whole };

/// The trailing edge of the formula: closed, or open as first published.
enum class TrailingEdge { sharp, blunt };

/// The NACA airfoil `code` (four digits: camber, its place, thickness), the leading edge at the
/// origin, the chord along +x, z = 0 [Jacobs, Ward & Pinkerton 1933, NACA Report 460]; thickness is
/// laid off normal to the camber line. The last coefficient of the thickness is -0.1036 when sharp,
/// -0.1015 when blunt. The parameter p is such that x is about p^2, so that it is regular at the
/// leading edge: 0 to 1 on a side, -1 (upper) to 1 (lower) on the whole, which is closed when
/// sharp. Sides start at the origin and, when sharp, end at (chord, 0), exactly.
/// Faults: not four digits, no thickness, camber without a place or a place without camber.
/// Precondition: chord > 0.
CurveResult naca4(std::string_view code, double chord, AirfoilSide side, TrailingEdge edge);

}  // namespace hexweave
