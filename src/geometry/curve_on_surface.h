// SPDX-License-Identifier: Apache-2.0
// Curves that lie on surfaces: every point of them is a value of the surface at known parameters.
#pragma once

#include "geometry/curve.h"
#include "geometry/surface.h"
#include "geometry/surface_set.h"

namespace hexweave {

/// The image of the straight line between two parameter points, over 0 to 1. Parameters may lie
/// outside the range along which the surface is closed.
Curve parameter_line(const Surface& surface, const SurfaceParameters& from,
                     const SurfaceParameters& to);

/// The curve pushed onto the nearest points of the surfaces, with its own parameter: cubic splines
/// through the parameters of its feet, so close that the curve between them is the projection to
/// 1e-9 of the size of the surfaces where it is smooth. Where it goes from one surface to another
/// it has a break, and jumps by the gap that there is between the two. The projection of a curve
/// that is farther from the surfaces than these are curved need not be continuous.
Curve projected_curve(const Curve& curve, const SurfaceSet& surfaces);

}  // namespace hexweave
