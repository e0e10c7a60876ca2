// SPDX-License-Identifier: Apache-2.0
// Where the sides of a face that lies in a plane cross: no grid can lie between such sides.
#pragma once

#include <optional>

#include "core/vec3.h"
#include "topology/face_frame.h"
#include "topology/outline.h"

namespace hexweave {

/// Two edges that cross, by their indices, and where; the same one twice where it crosses itself.
struct EdgeCrossing {
    int first = 0;
    int second = 0;
    Vec3 place;
};

/// Where two edges of the four sides pass through each other, or one of them through itself;
/// nothing where the sides do not cross, or lie in no common plane (to 1e-6 of their size). Edges
/// that touch or run along each other do not cross; nor do those that meet at less than a
/// thousandth of a radian, which round-off may do. What happens on less than a fiftieth of an edge,
/// far from its ends, is missed.
std::optional<EdgeCrossing> find_crossing(const FrameSides& sides, const EdgeLookup& edge);

}  // namespace hexweave
