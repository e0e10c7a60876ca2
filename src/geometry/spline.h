// SPDX-License-Identifier: Apache-2.0
// Interpolating cubic splines: through the points, two continuous derivatives.
#pragma once

#include <optional>
#include <vector>

#include "core/vec3.h"
#include "geometry/curve.h"
#include "geometry/curve_result.h"

namespace hexweave {

/// What fixes a spline at an end where no tangent is given: a third derivative that is continuous
/// across the first inner point (which makes the spline exact for cubics), or no curvature.
enum class SplineEnd { not_a_knot, natural };

struct SplineEnds {
    SplineEnd start = SplineEnd::not_a_knot;
    SplineEnd end = SplineEnd::not_a_knot;
    std::optional<Vec3> start_tangent;  ///< along the curve; only its direction counts
    std::optional<Vec3> end_tangent;
    bool corner =
        false;  ///< where first and last point coincide: a corner instead of a smooth join
};

/// The cubic spline through the points, parametrized by chord length from the first one. Closed
/// when the first and the last point are the same; then also periodic (smooth there), unless a
/// corner is asked or a tangent given. The inner points are breaks (of the third derivative).
/// Faults: fewer than two points (four when periodic), two consecutive points that coincide, a
/// tangent of no length.
CurveResult spline(const std::vector<Vec3>& points, const SplineEnds& ends = {});

/// The same at given parameters; tangents are derivatives by that parameter, at full length.
/// Precondition: as many parameters as points, strictly increasing; at least two (four when
/// periodic).
Curve spline_at(const std::vector<double>& parameters, const std::vector<Vec3>& points,
                const SplineEnds& ends = {});

}  // namespace hexweave
