// SPDX-License-Identifier: Apache-2.0
// How far the edges of a face are off the surface that the face lies on.
#pragma once

#include "core/vec3.h"

namespace hexweave {

/// The farthest of the boundary nodes of a face on a surface.
struct OffSurface {
    double distance = 0;
    Vec3 place;
    double size = 0;  ///< of the surface, or of all that the face lies on

    void include(double other, const Vec3& at) {
        if (!(other > distance)) return;
        distance = other;
        place = at;
    }
};

}  // namespace hexweave
