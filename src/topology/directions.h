// SPDX-License-Identifier: Apache-2.0
// The directions in which a face runs through its edges, inferred from their end vertices.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/orientation.h"
#include "topology/topology.h"

namespace hexweave {

/// An edge as a side names it: its end vertices and, where the user says so, its direction.
struct EdgeOfSide {
    int edge = 0;
    int start = 0;
    int end = 0;
    std::optional<bool> reversed;
    bool pole = false;

    int first(bool backwards) const { return backwards ? end : start; }
    int last(bool backwards) const { return backwards ? start : end; }
};

/// A side run through along increasing i or j, from vertex `start` to vertex `end`.
struct SideChain {
    int start = 0;
    int end = 0;
    std::vector<EdgeUse> uses;
};

/// The four sides of a face, indexed by Side::imin .. Side::jmax.
using FaceLoop = std::array<SideChain, 4>;

/// All ways to run through the edges in the order given so that each begins where the one before
/// ends; at most 16 of them.
std::vector<SideChain> side_chains(const std::vector<EdgeOfSide>& side);
/// All choices of a chain for each side that meet in the four corners; at most 16 of them.
std::vector<FaceLoop> face_loops(const std::array<std::vector<SideChain>, 4>& sides);

/// A corner of a face: the two sides that meet there, and at which end of each.
struct FaceCorner {
    Side along_i;  ///< jmin or jmax
    bool at_end_of_i_side;
    Side along_j;  ///< imin or imax
    bool at_end_of_j_side;
};
/// The corners in the order (imin,jmin), (imax,jmin), (imax,jmax), (imin,jmax).
const std::array<FaceCorner, 4>& face_corners();
/// The corners in which the sides do not meet.
std::vector<std::size_t> open_corners(const FaceLoop& loop);
/// The choice of a chain for each side that leaves the fewest corners open.
FaceLoop most_closed_loop(const std::array<std::vector<SideChain>, 4>& sides);

}  // namespace hexweave
