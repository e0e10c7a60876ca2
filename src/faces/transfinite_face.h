// SPDX-License-Identifier: Apache-2.0
// Transfinite interpolation of a face: the start grid of the elliptic system, and a grid of its
// own.
#pragma once

#include "core/field.h"
#include "elliptic/elliptic_solver.h"

namespace hexweave {

/// Fills the interior of a face from its boundary points, with the parameters s, t of its nodes as
/// blending coordinates: the bilinear map of the four corners plus the blended deviations of the
/// four sides from it. Boundary points are not touched. Where opposite sides have the same
/// parameters this is the Boolean sum of Gordon & Hall (1973); where they differ it is still exact
/// for every bilinear map, which the usual form is not.
void interpolate_face(PointField& points, const ParameterField& parameters);

}  // namespace hexweave
