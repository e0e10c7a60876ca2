// SPDX-License-Identifier: Apache-2.0
// Faces of a planar grid: whether their sides run round them once, counter-clockwise.
#pragma once

#include <cstddef>
#include <optional>

#include "core/diagnostics.h"
#include "topology/crossing_faults.h"
#include "topology/crossings.h"

namespace hexweave {

/// Reports a face of a planar grid whose sides cross or run round it in opposite senses, that
/// encloses nothing, or that is left-handed. False where no grid can lie between its sides.
bool check_planar_face(CrossingFaults& faults, std::size_t index,
                       const std::optional<EdgeCrossing>& crossing);

}  // namespace hexweave
