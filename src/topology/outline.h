// SPDX-License-Identifier: Apache-2.0
// Whether the four sides of a planar face can hold a grid at all: how often their outline turns.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "topology/face_frame.h"
#include "topology/topology.h"

namespace hexweave {

/// Edges by their index, finished or in the making.
using EdgeLookup = std::function<const Edge&(int)>;
/// Those of a topology, which must outlive the result.
EdgeLookup edges_of(const Topology& topology);

/// How often the outline of a planar face turns while it is walked once, jmin and imax forwards,
/// jmax and imin backwards. The outline of whatever is the image of a square without a fold turns
/// once, counter-clockwise (Hopf's Umlaufsatz for immersed discs); -1 is a left-handed face, any
/// other number one whose sides cross or run round in opposite senses. Nothing where it cannot be
/// told: a point off the plane z = 0, a cusp, detail that the samples miss.
std::optional<int> outline_turns(const FrameSides& sides, const EdgeLookup& edge);

/// The sides with a part of one of them that begins and ends in the same vertex run through the
/// other way, such that the outline turns once; nothing where no such part is found.
struct Rerouted {
    std::size_t side = 0;
    std::vector<EdgeUse> uses;
};
std::optional<Rerouted> reroute(const FrameSides& sides, const EdgeLookup& edge);

/// A chain as it is written in a case: "far", "[-base, +ring]"; signs where they are needed.
std::string chain_text(const std::vector<EdgeUse>& uses, const EdgeLookup& edge);

}  // namespace hexweave
