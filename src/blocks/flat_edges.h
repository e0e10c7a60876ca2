// SPDX-License-Identifier: Apache-2.0
// Edges of blocks where two sides meet so flat that the arc length is a poor edge function there,
// and the exponents that the edges which end in them take instead.
#pragma once

#include <string>
#include <vector>

#include "blocks/bilinear_map.h"
#include "faces/edge_functions.h"
#include "faces/face_grid.h"
#include "topology/topology.h"

namespace hexweave {

/// The edges of the topology that make up each edge of a block, along its axis.
PerBlockEdge<std::vector<EdgeUse>> block_edges(const Topology& topology, const Block& block);

/// Whether two sides of the block meet flat along each of its edges: at more than half of the
/// edge's nodes the angle between the first cells of the two sides, seen along the edge and through
/// the block, is between flat_angle and slit_angle.
PerBlockEdge<bool> flat_edges(const Block& block, const std::vector<FaceGrid>& faces);

/// What follows from the flat edges of one block and its neighbours.
struct BlockEdgeFunctions {
    PerBlockEdge<EndExponents> exponents;
    std::vector<std::string> flat;  ///< names of the block's own flat edges
};

/// For every block of the topology. An end of an edge that lies in a flat edge of some block takes
/// that block's flat_edge_exponent (the least of several) in all blocks that have the edge, so that
/// blocks on the two sides of a face use the same edge functions on it.
std::vector<BlockEdgeFunctions> block_edge_functions(const Topology& topology,
                                                     const std::vector<FaceGrid>& faces);

}  // namespace hexweave
