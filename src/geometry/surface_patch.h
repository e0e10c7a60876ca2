// SPDX-License-Identifier: Apache-2.0
// A quadrilateral part of a surface, bounded by four lines of points.
#pragma once

#include <array>
#include <vector>

#include "core/vec3.h"
#include "geometry/surface_projection.h"

namespace hexweave {

/// The sides imin and imax (along increasing j), jmin and jmax (along increasing i).
struct PatchSides {
    std::array<std::vector<SurfacePoint>, 4> sides;
    /// Once round the boundary comes back to the parameters that it began with. If not, the
    /// boundary goes round the surface: it encloses a pole or runs round a tube.
    bool closes = true;
};

/// The parameters of the points of four sides, which share their corners, each continued from the
/// one before all round the boundary: an edge that is both imin and imax may lie on both ends of
/// the range.
PatchSides sides_on_surface(const SurfaceProjection& projection,
                            const std::array<std::vector<Vec3>, 4>& sides);

}  // namespace hexweave
