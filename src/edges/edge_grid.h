// SPDX-License-Identifier: Apache-2.0
// Stage 3: points on edges.
#pragma once

#include <array>
#include <vector>

#include "core/vec3.h"
#include "topology/topology.h"

namespace hexweave {

/// The points of one edge, cells + 1 of them, from its start vertex to its end vertex.
struct EdgeGrid {
    std::vector<Vec3> points;
    std::vector<double> parameters;  ///< of the edge's curve
    std::vector<double> fractions;   ///< normalized arc length, 0 to 1
    /// Parameters at which the law's own first cell ends and its last begins: in a nested family
    /// those of the level `medium`.
    std::array<double, 2> law_cells{};
};

/// One grid per edge of the topology, in its order. End points are the vertices to the bit; points
/// on planes, and z of a planar topology, are there exactly.
std::vector<EdgeGrid> make_edges(const Topology& topology);

/// The arc lengths of the first and the last cell of an edge, measured on its curve between the
/// parameters of the grid, not taken from the law.
double first_cell(const Edge& edge, const EdgeGrid& grid);
double last_cell(const Edge& edge, const EdgeGrid& grid);

/// The same of the law's own cells, which are what is asked for; those of the grid unless it is of
/// another level than `medium` of a nested family.
double first_law_cell(const Edge& edge, const EdgeGrid& grid);
double last_law_cell(const Edge& edge, const EdgeGrid& grid);

/// Every `stride`-th point.
EdgeGrid every_nth(const EdgeGrid& grid, int stride);

}  // namespace hexweave
