// SPDX-License-Identifier: Apache-2.0
// Curves that lie on a surface: images of curves in the plane of its parameters.
#pragma once

#include <string>
#include <vector>

#include "core/vec3.h"
#include "geometry/curve.h"
#include "geometry/surface.h"

namespace hexweave {

/// The image of a planar curve, whose x is u and y is v: same parameter. Where it crosses a break
/// of the surface it has one. Closed where its ends coincide, to 1e-12 of its extent.
Curve curve_on(const Surface& surface, const Curve& in_parameters);

/// The line of equal u (v): its parameter is v (u), which runs from `begin` to `end`.
/// Precondition: begin < end, within the range or, where the surface is closed, at most a period.
Curve line_of_equal_u(const Surface& surface, double u, double begin, double end);
Curve line_of_equal_v(const Surface& surface, double v, double begin, double end);

/// A curve on a surface through the points of it that are nearest to given ones.
struct ProjectedCurve {
    Curve curve;
    double distance = 0;       ///< the greatest from a given point to its nearest
    std::size_t farthest = 0;  ///< the index of that point
    double size = 0;           ///< of the surface
    std::string fault;         ///< why there is no curve; or empty
};

/// Its u and v are cubic splines through those of the nearest points, over the length of the
/// polyline between these. Closed where the first and last point are the same, and then smooth
/// there unless a `corner` is asked. Not of less than two points, nor of consecutive ones that
/// coincide on the surface.
ProjectedCurve curve_through(const Surface& surface, const std::vector<Vec3>& points,
                             bool corner = false);

}  // namespace hexweave
