// SPDX-License-Identifier: Apache-2.0
// Surfaces made from others, or from curves, without a change of shape: parts, other parameters,
// curves carried along curves.
#pragma once

#include <array>

#include "geometry/curve.h"
#include "geometry/surface.h"

namespace hexweave {

/// The part over other ranges of the same parameters. Along a closed parameter a range may lie
/// outside, across the seam; the part is closed there when it is a whole period.
/// Precondition: ascending ranges within those of the surface, or at most a period long.
Surface surface_part(const Surface& surface, const std::array<double, 2>& range_u,
                     const std::array<double, 2>& range_v);

/// The same points with u for v and v for u.
Surface swapped(const Surface& surface);

/// The same points, u (v) running against that of the surface over the same range.
Surface reversed_u(const Surface& surface);
Surface reversed_v(const Surface& surface);

/// A curve carried along a path: curve(u) + path(v) - path(begin); the two curves' own parameters.
Surface extrusion(const Curve& curve, const Curve& path);

}  // namespace hexweave
