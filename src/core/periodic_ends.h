// SPDX-License-Identifier: Apache-2.0
// What files say of periodic interfaces: whether two of them say the same, and whether the two ends
// of one agree. What counts is where the points of a grid are carried, in the single precision in
// which files keep angles and lengths: not which numbers say it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/grid_outline.h"
#include "core/point_box.h"

namespace hexweave {

/// Whether both carry the points of a box to the same places. Nothing is not the same as a
/// periodicity that moves nothing.
bool same_periodicity(const std::optional<Periodicity>& a, const std::optional<Periodicity>& b,
                      const PointBox& box);

/// "not periodic", "periodic by rotation (0, 0, 0.5) about (0, 0, 0) and translation (0, 0, 0)".
std::string to_text(const std::optional<Periodicity>& periodic);

/// A sentence for every interface of which one end does not lead back where the other one comes
/// from; `box` is that of the grid.
std::vector<std::string> contradictions(const GridOutline& grid, const PointBox& box);

}  // namespace hexweave
