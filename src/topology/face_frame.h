// SPDX-License-Identifier: Apache-2.0
// A face seen in the axes of the block's side that it covers.
#pragma once

#include <array>
#include <vector>

#include "core/orientation.h"
#include "topology/topology.h"

namespace hexweave {

/// The four sides of a face as a block's side sees them: at the minimum and the maximum of its
/// first axis (run along the second), then of its second (run along the first).
using FrameSides = std::array<std::vector<EdgeUse>, 4>;

/// The same edges run through backwards.
std::vector<EdgeUse> backwards(const std::vector<EdgeUse>& side);

/// `orientation` takes the block side's two axes to the face's.
FrameSides sides_in_frame(const FrameSides& face_sides, const Orientation& orientation);
/// The corners at (min, min), (max, min), (max, max), (min, max) of the block side's axes.
std::array<int, 4> corners_in_frame(const std::array<int, 4>& corners,
                                    const Orientation& orientation);

/// The four sides of faces in rows of `columns`, each face already seen in the axes of the block's
/// side: chains over all faces along the border.
FrameSides joined_frame(const std::vector<FrameSides>& faces, int columns);
/// The four sides of a whole side of a block.
FrameSides sides_in_frame(const std::vector<Face>& faces, const BlockSide& side);

/// Tells the faces of a block's side where they begin, from their counts of cells; returns the
/// extent of the whole side.
Extent place_faces(const std::vector<Face>& faces, BlockSide& side);

/// Corner (i, j, k), each 0 or 1, in the order of the CGNS hexahedron.
constexpr std::size_t hexahedron_corner(int i, int j, int k) {
    const int corner = 4 * k + (j == 0 ? i : 3 - i);
    return static_cast<std::size_t>(corner);
}
/// The hexahedron's corners at (min, min), (max, min), (max, max), (min, max) of a side's own axes.
std::array<std::size_t, 4> corners_of_side(Side side);

}  // namespace hexweave
