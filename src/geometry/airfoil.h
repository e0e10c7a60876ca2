// SPDX-License-Identifier: Apache-2.0
// Airfoils through given points: one spline through the whole section, smooth at the leading edge,
// with a corner at the trailing edge.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/vec3.h"
#include "geometry/airfoil_file.h"
#include "geometry/curve.h"
#include "geometry/curve_result.h"
#include "geometry/naca.h"

namespace hexweave {

struct AirfoilShape {
    AirfoilSide side = AirfoilSide::whole;
    /// Closes a blunt trailing edge: each side is sheared, by an amount that grows linearly along
    /// the chord from nothing at the leading edge, so that both end in the middle of the base.
    bool close_trailing_edge = false;
    /// Moves the leading edge to the origin and scales the section so that its trailing edge (the
    /// middle of the base) lies at x = chord. Where absent, coordinates stay as they are.
    std::optional<double> chord;
};

/// The airfoil through points in the order of AirfoilPoints, same conventions as naca_airfoil. The
/// leading edge is the point farthest from the trailing edge: a given point, unless the spline
/// reaches out farther than that by more than 1e-5 of the chord. `whole` is closed when the section
/// ends where it starts. Faults: fewer than five points, coincident ones, no extent along x.
/// Precondition: chord > 0.
CurveResult airfoil(const std::vector<Vec3>& points, const AirfoilShape& shape);

/// Reads a coordinate file and makes its curve; faults of either, with their line.
CurveResult airfoil_from_text(std::string_view text, AirfoilContent content,
                              const AirfoilShape& shape);

}  // namespace hexweave
