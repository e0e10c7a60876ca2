// SPDX-License-Identifier: Apache-2.0
// Transfinite interpolation of a block: the start grid of the elliptic system, and a grid of its
// own.
#pragma once

#include "core/field.h"
#include "elliptic/elliptic_solver.h"

namespace hexweave {

/// Fills the interior of a block from its boundary points, with the parameters s, t, u of its nodes
/// as blending coordinates: the trilinear map of the eight corners plus the blended deviations of
/// the six faces from it, less those of the twelve edges. Boundary points are not touched. Where
/// opposite edges have the same parameters this is the Boolean sum of Gordon & Hall (1973); where
/// they differ it is still exact for every trilinear map, which the usual form is not.
void interpolate_block(PointField& points, const ParameterField& parameters);

}  // namespace hexweave
