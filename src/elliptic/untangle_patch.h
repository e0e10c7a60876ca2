// SPDX-License-Identifier: Apache-2.0
// A patch: a part of a grid whose interior points may move so that no cell of it is folded, as
// compact arrays of its own.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/field.h"
#include "elliptic/lattice_runs.h"

namespace hexweave {

/// The cell that a corner should be like, through the Gram matrix G of its three (two) edges.
struct TargetCorner {
    std::array<double, 6> inverse_gram{};  ///< of G^-1: 00, 01, 02, 11, 12, 22
    double inverse_volume = 0;             ///< det(G)^-1/2; 0: the corner is left out
};

/// How a pair of a node's neighbours follow each other in the matrix of a patch: the nodes ahead of
/// a node, those of a face first.
inline constexpr std::array<Node, 9> nodes_ahead{{{1, 0, 0},
                                                  {0, 1, 0},
                                                  {1, 1, 0},
                                                  {-1, 1, 0},
                                                  {0, 0, 1},
                                                  {1, 0, 1},
                                                  {-1, 0, 1},
                                                  {0, 1, 1},
                                                  {0, -1, 1}}};
inline constexpr std::array<std::size_t, 3> ahead_along_axis{0, 1, 4};

struct Patch {
    int axes = 3;
    int thin_axis = 2;  ///< the axis along which its cells are thinnest

    // Nodes: the free ones and those of their cells.
    std::vector<std::size_t> nodes;  ///< their places in the grid, ascending
    std::vector<Vec3> points;
    std::vector<int> free_of;  ///< number among the free nodes; -1: fixed

    // Free nodes.
    std::vector<int> free;  ///< their numbers among the nodes
    /// The free nodes ahead of and behind each free node (-1: fixed), couplings() numbers a node.
    std::vector<int> ahead;
    std::vector<int> behind;

    // Cells with a free node: corner c is at the high end of axis a when bit a of c is set.
    std::vector<std::array<int, 8>> cells;
    std::vector<std::size_t> slabs;     ///< where layers of cells begin, two or more each; the end
    std::vector<Vec3> normals;          ///< of a face: one for each cell, of length 1
    std::vector<TargetCorner> targets;  ///< corners() for each cell

    std::size_t couplings() const { return axes == 3 ? 9 : 4; }
    int corners() const { return axes == 3 ? 8 : 4; }
    /// Large enough for several threads.
    bool is_shared() const { return free.size() > 30000; }
};

/// The patch in which the nodes `free` (none of them on the boundary) may move; without targets.
/// `plane`: as plane_normal gives it.
Patch make_patch(const PointField& points, const Runs& free, int thin_axis, const Vec3& plane);

/// +1 or -1: the sign of the determinant of a sound cell's legs at corner c, seen from the corner.
constexpr int corner_sign(int c, int axes) {
    const int bits = (c & 1) + ((c >> 1) & 1) + (axes == 3 ? (c >> 2) & 1 : 0);
    return bits % 2 == 0 ? 1 : -1;
}

/// The legs of corner c of a cell; on a face the third is the cell's normal.
inline std::array<Vec3, 3> corner_legs(const Patch& patch, std::size_t cell, int c) {
    const auto& nodes = patch.cells[cell];
    const auto at = [&](int corner) {
        return patch.points[static_cast<std::size_t>(nodes[static_cast<std::size_t>(corner)])];
    };
    const Vec3 origin = at(c);
    return {at(c ^ 1) - origin, at(c ^ 2) - origin,
            patch.axes == 3 ? at(c ^ 4) - origin : patch.normals[cell]};
}

/// Whether an axis end of corner c (0: itself, 1 ... axes: along an axis) is a free node.
inline int corner_node(const Patch& patch, std::size_t cell, int c, int vertex) {
    const int corner = vertex == 0 ? c : c ^ (1 << (vertex - 1));
    return patch.cells[cell][static_cast<std::size_t>(corner)];
}

/// Cells of the patch with a folded corner among those that have a target: the others cannot be
/// cured.
long count_folded(const Patch& patch);

}  // namespace hexweave
