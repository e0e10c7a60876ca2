// SPDX-License-Identifier: Apache-2.0
// The Laplace operator on the nodes of a face, as a network: every node is joined to its eight
// neighbours by conductances, and at a harmonic field the currents into a node add up to nothing.
// Sides that no current crosses need no equation of their own: it is the Neumann condition.
#pragma once

#include <array>

#include "core/field.h"

namespace hexweave {

/// Conductances between nodes. The fields have a ring of ghost nodes round the face's (node (i, j)
/// is at (i + 1, j + 1)) to which nothing conducts, so that no node is a special case.
struct Conductances {
    int ni = 0;  ///< nodes of the face
    int nj = 0;
    Field east;     ///< (i, j) to (i + 1, j)
    Field north;    ///< (i, j) to (i, j + 1)
    Field rising;   ///< (i, j) to (i + 1, j + 1)
    Field falling;  ///< (i + 1, j) to (i, j + 1)

    Conductances(int nodes_i, int nodes_j);

    /// The current into a node (flat position with ghosts): the sum over its neighbours of the
    /// conductance times the difference of `values`.
    double current(const double* values, std::size_t node) const;
    /// The sum of the conductances to the row below and above (axis 0: the columns beside).
    double across(std::size_t node, int axis) const;
};

/// Finite volumes on the grid of a planar or curved face without folded cells: across each piece
/// of the border between two control volumes flows the current of the along-edge difference, plus
/// the mixed part, whose energy is one of differences along the cell's diagonals. Five points where
/// the grid is orthogonal; symmetric and positive always; second order.
/// [Spekreijse & Boerstoel 1996, eqs. (50)-(53)]
Conductances laplace_conductances(const PointField& points);

/// Bilinear finite elements on the same grid, by four Gauss points a cell. They are exact for
/// fields that are linear in space, on any grid, so that the values tell how far every node is from
/// its place; the finite volumes do not see nodes that are displaced to and fro in turn. Nine
/// points; where cells are long some conductances are negative, but the whole is positive.
Conductances element_conductances(const PointField& points);

/// How one axis is coarsened: every other node is kept, and the last; two cells stay two.
struct AxisCoarsening {
    int fine = 0;    ///< nodes
    int coarse = 0;  ///< nodes

    explicit AxisCoarsening(int fine_nodes);

    bool keeps_all() const { return coarse == fine; }
    /// The fine node that a coarse node is.
    int fine_node(int coarse_node) const;
    /// The coarse cell that holds a fine node, the lower one where it is between two.
    int cell_of(int fine_node_index) const;
    /// Where in that cell: 0 at its lower node, 1 at its upper, a half between.
    double fraction(int fine_node_index, int cell) const;
};

/// The network of the coarse nodes that spends the same power at every coarse field as the fine one
/// at its bilinear interpolation (Galerkin).
Conductances coarsen(const Conductances& fine, const AxisCoarsening& along_i,
                     const AxisCoarsening& along_j);

}  // namespace hexweave
