// SPDX-License-Identifier: Apache-2.0
// What the corners of a patch's cells should look like: the aim of untangling decides whether its
// result fits the grid around it.
#pragma once

#include <array>

#include "core/field.h"
#include "elliptic/untangle_patch.h"

namespace hexweave {

/// The patch's own corners as they stand, those with a scaled Jacobian below 0.15 sheared back: the
/// leg along `thin_axis` is turned towards the normal of the other two until it is 0.15, after the
/// angle between those was opened (or closed) to a sine of 0.39. Lengths stay. Sound corners are
/// their own aim, so that the patch joins its surroundings without a seam. Corners that no interior
/// node can make sound have no target.
void aim_at_sheared_cells(Patch& patch);

/// Boxes whose sides have the lengths that the boundary suggests: those of the grid's edges on its
/// boundary, their logarithms blended by transfinite interpolation. For starts whose own cells say
/// nothing. `grid` is the whole grid, and only its boundary nodes are used.
void aim_at_boxes(Patch& patch, const PointField& grid);

/// The target for a corner with the given legs (on a face two, and its normal of length 1).
/// `sign`: that of the determinant of a sound corner's legs. The legs have lengths.
TargetCorner sheared_corner(const std::array<Vec3, 3>& legs, int sign, int axes, int thin_axis);

}  // namespace hexweave
