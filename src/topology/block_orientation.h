// SPDX-License-Identifier: Apache-2.0
// How the faces of a block lie on its six sides, inferred from the edges that they share.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/orientation.h"
#include "topology/face_frame.h"
#include "topology/side_arrangement.h"

namespace hexweave {

/// What is known of the faces of a block, in the order of the sides.
using FacesOfBlock = std::array<SideFaces, 6>;
/// For every side the way in which its faces lie on it.
using BlockArrangement = std::array<SideArrangement, 6>;

/// All choices of an arrangement for each side such that the twelve edges of the block are the same
/// on both sides that share each; at most 16 of them.
std::vector<BlockArrangement> block_arrangements(const FacesOfBlock& faces);

/// Pairs of adjacent sides that have no edge of the block in common, whatever their arrangement.
std::vector<std::pair<Side, Side>> strangers(const FacesOfBlock& faces);

/// What each of two adjacent sides may have for the edge between them: all pairs of a chain of
/// edges of side `a` and one of side `b`.
using ChainPair = std::pair<std::vector<EdgeUse>, std::vector<EdgeUse>>;
std::vector<ChainPair> chains_between(const FacesOfBlock& faces, Side a, Side b);

/// The orientations in which a face has the sides asked for.
std::vector<Orientation> matching_orientations(const FrameSides& face, const FrameSides& asked);

}  // namespace hexweave
