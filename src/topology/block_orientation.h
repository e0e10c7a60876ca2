// SPDX-License-Identifier: Apache-2.0
// How six faces lie on the sides of a block, inferred from the edges that they share.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/orientation.h"
#include "topology/face_frame.h"

namespace hexweave {

/// What is known of a block's six faces, in the order of the sides.
struct FacesOfBlock {
    std::array<FrameSides, 6> sides;                     ///< each face's own imin .. jmax
    std::array<std::optional<Orientation>, 6> required;  ///< by the user
};

using BlockOrientations = std::array<Orientation, 6>;

/// All choices of an orientation for each face such that the twelve edges of the block are the same
/// on both faces that share each; at most 16 of them.
std::vector<BlockOrientations> block_orientations(const FacesOfBlock& faces);

/// Pairs of adjacent sides whose faces have no side in common, whatever their orientation.
std::vector<std::pair<Side, Side>> strangers(const FacesOfBlock& faces);

/// The orientations in which a face has the sides asked for.
std::vector<Orientation> matching_orientations(const FrameSides& face, const FrameSides& asked);

}  // namespace hexweave
