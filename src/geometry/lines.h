// SPDX-License-Identifier: Apache-2.0
// Straight lines and polylines.
#pragma once

#include <vector>

#include "core/vec3.h"
#include "geometry/curve.h"
#include "geometry/curve_result.h"

namespace hexweave {

/// The straight line from a to b, parameter 0 to 1. Precondition: a differs from b.
Curve straight_line(const Vec3& a, const Vec3& b);

/// Straight lines from point to point; the parameter is the length from the first one. The inner
/// points are breaks. Closed when the first and the last point are the same.
/// Faults: fewer than two points, two consecutive points that coincide.
CurveResult polyline(const std::vector<Vec3>& points);

}  // namespace hexweave
