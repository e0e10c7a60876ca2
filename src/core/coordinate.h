// SPDX-License-Identifier: Apache-2.0
// A coordinate of a point by the number of its axis.
#pragma once

#include "core/vec3.h"

namespace hexweave {

/// x, y or z for the axis 0, 1 or 2.
inline double& coordinate(Vec3& point, int axis) {
    return axis == 0 ? point.x : axis == 1 ? point.y : point.z;
}

}  // namespace hexweave
