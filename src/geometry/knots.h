// SPDX-License-Identifier: Apache-2.0
// Parameters for curves through points: chord lengths, and the interval a parameter falls in.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/vec3.h"

namespace hexweave {

/// The length of the polyline up to each point, from 0.
std::vector<double> chord_length_knots(const std::vector<Vec3>& points);

/// The interval k with knots[k] <= t < knots[k + 1]; the first and the last one reach beyond the
/// ends. Precondition: at least two knots, ascending.
std::size_t knot_interval(const std::vector<double>& knots, double t);

/// "points 3 and 4 coincide" (counted from 1) where the chord between consecutive points is lost in
/// the length of the whole (1e-14 of it), or nothing.
std::string coincident_points(const std::vector<Vec3>& points);

}  // namespace hexweave
