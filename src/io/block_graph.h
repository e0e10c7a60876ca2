// SPDX-License-Identifier: Apache-2.0
// Which blocks share which faces, as a graph: a circle per block, a line per shared face (a loop
// where a block meets itself, broken where the pair is periodic), a square per free side in the
// colour of its family.
#pragma once

#include <vector>

#include "io/label_placement.h"
#include "io/picture_drawing.h"
#include "io/topology_layout.h"
#include "topology/topology.h"

namespace hexweave {

/// The mean of a block's corners on the page of `layout`.
PagePoint block_centre(const Block& block, const TopologyLayout& layout);

/// The family of each edge (planar and surface grids) or face (grids of blocks); -1: none.
std::vector<int> families_of_sides(const Topology& topology);

/// Draws the graph into a frame; blocks stand round a circle as they do in `layout`, one in their
/// midst at its centre.
void append_block_graph(const Topology& topology, const TopologyLayout& layout, const Frame& frame,
                        Drawing& drawing);

}  // namespace hexweave
