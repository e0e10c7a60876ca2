// SPDX-License-Identifier: Apache-2.0
// Circles, arcs and ellipses, in the plane z = const or in any plane.
#pragma once

#include <optional>

#include "core/vec3.h"
#include "geometry/curve.h"
#include "geometry/curve_result.h"

namespace hexweave {

/// Two perpendicular unit vectors that span a plane; angles count from x towards y.
struct PlaneAxes {
    Vec3 x{1, 0, 0};
    Vec3 y{0, 1, 0};
};

/// The axes of the plane with this normal, x being the part of `x_axis` in the plane; where none is
/// given, of the global x axis, or of the global y axis when the normal is along x. Angles run
/// counter-clockwise when seen against the normal. Nothing when the normal is zero or parallel to
/// `x_axis`.
std::optional<PlaneAxes> plane_axes(const Vec3& normal, const std::optional<Vec3>& x_axis = {});

/// A full circle: starts at `center` + `radius` along x, counter-clockwise, closed; the parameter
/// counts quarter turns, 0 to 4. Precondition: radius > 0.
Curve circle(const Vec3& center, double radius, const PlaneAxes& axes = {});

/// The arc from angle `from` to angle `to` (radians); clockwise when `to` < `from`. Precondition:
/// radius > 0, 0 < |to - from| <= 2 pi.
Curve arc(const Vec3& center, double radius, double from, double to, const PlaneAxes& axes = {});

/// The arc from `start` through `middle` to `end`. Faults: two points coincide, the three lie on a
/// line.
CurveResult arc_through(const Vec3& start, const Vec3& middle, const Vec3& end);

/// A full ellipse with half-axis `a` at angle `rotation` (radians) from x and half-axis `b`
/// perpendicular to it: starts at the end of the first half-axis, counter-clockwise, closed; the
/// parameter counts quarter turns of the eccentric anomaly, 0 to 4. Precondition: a > 0, b > 0.
Curve ellipse(const Vec3& center, double a, double b, double rotation = 0,
              const PlaneAxes& axes = {});

}  // namespace hexweave
