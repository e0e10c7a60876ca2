// SPDX-License-Identifier: Apache-2.0
// NACA airfoils of four and five digits, from their formulas.
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

/// The NACA airfoil `code`, the leading edge at the origin, the chord along +x, z = 0; thickness is
/// laid off normal to the camber line. Four digits: greatest camber (per cent), its place (tenths),
/// thickness (per cent) [Jacobs, Ward & Pinkerton 1933, NACA Report 460]. Five: design lift
/// (times 3/20), place of the greatest camber (twentieths, 1 to 5), 0 or 1 for a reflexed camber
/// line of no pitching moment (places 2 to 5), thickness [Jacobs & Pinkerton 1935, NACA Report
/// 537], with the rounded constants of that report's tables. The last coefficient of the thickness
/// is -0.1036 when sharp, -0.1015 when blunt. The parameter p is such that x is about p^2, so that
/// it is regular at the leading edge: 0 to 1 on a side, -1 (upper) to 1 (lower) on the whole, which
/// is closed when sharp. Sides start at the origin and, when sharp, end at (chord, 0), exactly.
/// Faults: not four or five digits, no thickness, camber without a place or a place without camber,
/// a camber line that the tables do not have. Precondition: chord > 0.
CurveResult naca_airfoil(std::string_view code, double chord, AirfoilSide side, TrailingEdge edge);

}  // namespace hexweave
