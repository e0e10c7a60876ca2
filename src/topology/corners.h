// SPDX-License-Identifier: Apache-2.0
// What is given by its corner vertices: the edges and faces between them, drawn or made.
#pragma once

#include <array>
#include <optional>

#include "topology/draft.h"
#include "topology/face_frame.h"

namespace hexweave {

/// The only edge between two vertices, run from a to b; none where there is none or a choice.
std::optional<EdgeUse> edge_between(Draft& draft, int a, int b);
/// The four edges between consecutive corners as sides imin, imax, jmin, jmax; none where
/// `edge_between` finds none.
std::optional<FrameSides> sides_between(Draft& draft, const std::array<int, 4>& corners);

}  // namespace hexweave
