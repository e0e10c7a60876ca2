// SPDX-License-Identifier: Apache-2.0
// A side of a face that is a pole of its surface: one point, which has many parameters.
#pragma once

#include "core/field.h"
#include "geometry/surface.h"

namespace hexweave {

/// `at` holds u and v of a face's boundary nodes, `points` the nodes themselves. On a side whose
/// nodes are all one point, and where a whole line of parameters is that point too, the parameters
/// are spread along that line from those of one neighbouring side to those of the other, so that
/// lines of the surface lead straight to the pole.
void spread_poles(const Surface& surface, const PointField& points, PointField& at);

}  // namespace hexweave
