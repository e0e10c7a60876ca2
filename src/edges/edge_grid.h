// SPDX-License-Identifier: Apache-2.0
// Stage 3: points on edges.
#pragma once

#include <vector>

#include "core/vec3.h"
#include "topology/topology.h"

namespace hexweave {

/// The points of one edge, cells + 1 of them, from its start vertex to its end vertex.
struct EdgeGrid {
    std::vector<Vec3> points;
    std::vector<double> parameters;  ///< of the edge's curve
    std::vector<double> fractions;   ///< normalized arc length, 0 to 1
};

/// One grid per edge of the topology, in its order. End points are the vertices to the bit; points
/// on planes, and z of a planar topology, are there exactly.
std::vector<EdgeGrid> make_edges(const Topology& topology);

/// The arc lengths of the first and the last cell of an edge, measured on its curve between the
/// parameters of the grid, not taken from the law.
double first_cell(const Edge& edge, const EdgeGrid& grid);
double last_cell(const Edge& edge, const EdgeGrid& grid);

}  // namespace hexweave
