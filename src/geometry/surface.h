// SPDX-License-Identifier: Apache-2.0
// Surfaces: shapes without points. A surface is a position and its two derivatives over a rectangle
// of parameters; every family (formula, plane, sphere, ruled, ...) is a function that returns one.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/vec3.h"
#include "geometry/curve.h"
#include "geometry/transform.h"

namespace hexweave {

struct SurfaceParameters {
    double u = 0;
    double v = 0;
};

/// A parametrized surface, one-to-one but for its seams and for edges that shrink to a line or a
/// point. The functions must be safe to call from several threads at once. Along a closed parameter
/// the surface may be evaluated outside its range: it wraps round.
struct Surface {
    std::function<Vec3(double, double)> position;
    std::function<Vec3(double, double)> derivative_u;
    std::function<Vec3(double, double)> derivative_v;
    std::array<double, 2> range_u{0, 1};
    std::array<double, 2> range_v{0, 1};
    bool closed_u = false;
    bool closed_v = false;
    std::vector<double> breaks_u{};  ///< interior parameters where a derivative of any order jumps
    std::vector<double> breaks_v{};
};

/// Sets closed_u and closed_v: closed along a parameter are surfaces whose two ends coincide
/// everywhere, to 1e-12 of their extent.
void find_closed(Surface& surface);

/// Position and derivatives. Parameters outside the range wrap round where the surface is closed;
/// where it is not they are taken to be those of the edge (they err by rounding only).
Vec3 evaluate(const Surface& surface, const SurfaceParameters& at);
Vec3 evaluate_derivative_u(const Surface& surface, const SurfaceParameters& at);
Vec3 evaluate_derivative_v(const Surface& surface, const SurfaceParameters& at);

/// The surface position(u, v) over ascending ranges. Its derivatives are taken by differences of
/// eighth order that never leave the ranges. Closed as by find_closed. Precondition: the formula is
/// finite.
Surface formula_surface(std::function<Vec3(double, double)> position,
                        const std::array<double, 2>& range_u, const std::array<double, 2>& range_v);

/// The parallelogram point + u along_u + v along_v, 0 <= u, v <= 1. Precondition: the two
/// directions are not parallel.
Surface plane_surface(const Vec3& point, const Vec3& along_u, const Vec3& along_v);

/// u is the longitude, 0 to 2 pi and closed, v the latitude, -pi/2 to pi/2. The axis points to the
/// north pole. Precondition: radius > 0, the axis is not zero.
Surface sphere(const Vec3& center, double radius, const Vec3& axis = {0, 0, 1});

/// The circular cylinder (cone, where the radii differ) about the line from `from` (v = 0) to `to`
/// (v = 1); u is the angle, 0 to 2 pi and closed. Precondition: the points differ, no radius is
/// negative and one is positive.
Surface cone(const Vec3& from, const Vec3& to, double radius_from, double radius_to);

/// Straight lines between the points of two curves at equal shares of their parameters: u from 0 to
/// 1 along the curves, v from 0 (`first`) to 1 (`second`). Closed along u where both curves are.
Surface ruled_surface(const Curve& first, const Curve& second);

/// A curve turned about the line through `center` along `axis`: u is the angle [rad], 0 to `turn`,
/// right-handed and closed when that is a full turn, v the curve's own parameter.
/// Precondition: 0 < turn <= 2 pi, the axis is not zero.
Surface revolution(const Curve& curve, const Vec3& center, const Vec3& axis, double turn);

/// The image of a surface; same parameters. Precondition: the map is invertible.
Surface transformed(const Surface& surface, const Affine& map);

}  // namespace hexweave
