// SPDX-License-Identifier: Apache-2.0
// The nodes of a face or block as one array of points, and how to step from node to node. The
// operator, the linear solver and the acceleration all walk over it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/field.h"

namespace hexweave::bench {

/// One vector for every node (boundary nodes too), i fastest: points, parameters, displacements.
using Nodes = std::vector<Vec3>;

/// Flat distances to the next node along i, j and k.
using Strides = std::array<std::ptrdiff_t, 3>;

/// A block has three axes; a face (nk = 1) has two.
struct NodeLattice {
    Extent extent;
    Strides strides{};
    int axes = 3;

    explicit NodeLattice(const Extent& e)
        : extent(e),
          strides{1, e.ni, static_cast<std::ptrdiff_t>(e.ni) * e.nj},
          axes(e.nk == 1 ? 2 : 3) {}

    bool has_interior() const {
        return extent.ni > 2 && extent.nj > 2 && (axes == 2 || extent.nk > 2);
    }
};

/// Calls visit(offset) for every interior node in ascending order.
template <class Visit>
void for_interior(const NodeLattice& lattice, Visit&& visit) {
    const Extent& e = lattice.extent;
    const int first_k = lattice.axes == 3 ? 1 : 0;
    const int last_k = lattice.axes == 3 ? e.nk - 2 : 0;
    for (int k = first_k; k <= last_k; ++k) {
        for (int j = 1; j < e.nj - 1; ++j) {
            const std::size_t begin = e.offset(1, j, k);
            const std::size_t end = begin + static_cast<std::size_t>(e.ni - 2);
            for (std::size_t p = begin; p < end; ++p) visit(p);
        }
    }
}

/// Calls visit(offset) for every interior node in descending order.
template <class Visit>
void for_interior_backwards(const NodeLattice& lattice, Visit&& visit) {
    const Extent& e = lattice.extent;
    const int first_k = lattice.axes == 3 ? 1 : 0;
    const int last_k = lattice.axes == 3 ? e.nk - 2 : 0;
    for (int k = last_k; k >= first_k; --k) {
        for (int j = e.nj - 2; j >= 1; --j) {
            const std::size_t begin = e.offset(1, j, k);
            const std::size_t end = begin + static_cast<std::size_t>(e.ni - 2);
            for (std::size_t p = end; p-- > begin;) visit(p);
        }
    }
}

}  // namespace hexweave::bench
