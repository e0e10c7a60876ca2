// SPDX-License-Identifier: Apache-2.0
// Affine maps, and curves made from other curves: moved, scaled, turned, mirrored, reversed, cut.
#pragma once

#include <array>

#include "core/vec3.h"
#include "geometry/curve.h"

namespace hexweave {

/// p -> (rows[0].p, rows[1].p, rows[2].p) + offset.
struct Affine {
    std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    Vec3 offset;
};

Vec3 apply(const Affine& map, const Vec3& point);
/// Without the offset: what the map does to a derivative.
Vec3 apply_to_direction(const Affine& map, const Vec3& direction);
/// First `first`, then `second`.
Affine compose(const Affine& first, const Affine& second);
/// Whether a map leaves every point as it is, to the last bit.
bool is_identity(const Affine& map);

Affine translation(const Vec3& by);
/// A factor for each axis, about `center`. Precondition: no factor is zero.
Affine scaling(const Vec3& factors, const Vec3& center = {});
/// Turns about the line through `center` along `axis`, right-handed, `angle` in radians, exactly by
/// multiples of a right angle; in two dimensions the axis is z. Precondition: the axis is not zero.
Affine rotation(const Vec3& axis, double angle, const Vec3& center = {});
/// Mirrors at the plane through `point` with this normal. Precondition: the normal is not zero.
Affine reflection(const Vec3& point, const Vec3& normal);

/// The image of a curve; same parameter. Precondition: the map is invertible.
Curve transformed(const Curve& curve, const Affine& map);

/// The same curve run through backwards: parameter -p where the given curve has p.
Curve reversed(const Curve& curve);

/// The part of a curve from parameter a to parameter b; same parameter, or -p when b < a, in which
/// case it runs backwards. On a closed curve a and b may lie outside the range, at most one period
/// apart. Precondition: a differs from b.
Curve piece(const Curve& curve, double a, double b);

/// The part between two fractions of the arc length, 0 to 1; backwards when `to` < `from`. On a
/// closed curve fractions may lie outside: 0.75 to 1.25 crosses the start. Precondition: they
/// differ, at most by 1.
Curve piece_by_fractions(const Curve& curve, double from, double to);

}  // namespace hexweave
