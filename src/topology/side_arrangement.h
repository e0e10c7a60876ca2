// SPDX-License-Identifier: Apache-2.0
// How the faces of one side of a block lie beside each other, inferred from the edges they share.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/orientation.h"
#include "topology/face_frame.h"

namespace hexweave {

/// The faces of a block's side as listed, row by row; a strip may run along either axis of the
/// side.
struct SideFaces {
    int columns = 1;
    bool strip = false;
    std::vector<FrameSides> faces;                     ///< each face's own imin .. jmax
    std::vector<std::optional<Orientation>> required;  ///< by the user, for each face
    std::vector<bool> collapsed;  ///< faces that are a line or a point: alike in some orientations
};

/// One way in which the faces of a side fit together.
struct SideArrangement {
    int columns = 1;
    std::vector<Orientation> orientations;  ///< of the faces, row by row
    FrameSides frame;                       ///< the sides of the whole
};

/// All ways (at most 64) in which faces that are neighbours in the arrangement have the side
/// between them, edge for edge, in common.
std::vector<SideArrangement> side_arrangements(const SideFaces& side);

/// How many of the faces, in the order of the list, fit together: all of them when there is an
/// arrangement. What is `required` does not count.
std::size_t fitting_faces(const SideFaces& side);

/// Whether two faces have a side in common, whatever their orientation.
bool share_a_side(const FrameSides& a, const FrameSides& b);

}  // namespace hexweave
