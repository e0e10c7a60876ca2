// SPDX-License-Identifier: Apache-2.0
// A side of a face or block seen from the wall: where the nodes on it and off it are.
#pragma once

#include <array>
#include <cstddef>

#include "core/field.h"
#include "core/orientation.h"

namespace hexweave {

/// A side seen from the wall: nodes (a, b) over its own two axes, and n steps inwards.
struct WallFrame {
    Extent extent;
    Side side;
    std::array<int, 2> axes;
    int count_a;
    int count_b;

    WallFrame(const Extent& e, Side s)
        : extent(e), side(s), axes(tangential_axes(s)), count_a(e[axes[0]]), count_b(e[axes[1]]) {}

    int depth() const { return extent[axis_of(side)]; }
    Extent nodes() const { return {count_a, count_b, 1}; }
    /// A face has no second axis along its sides.
    bool is_line() const { return count_b == 1; }
    bool fixed(int a, int b) const {
        return a == 0 || a == count_a - 1 || (!is_line() && (b == 0 || b == count_b - 1));
    }
    std::size_t offset(int a, int b, int n) const {
        Node node{};
        node[static_cast<std::size_t>(axes[0])] = a;
        node[static_cast<std::size_t>(axes[1])] = b;
        node[static_cast<std::size_t>(axis_of(side))] = is_max(side) ? depth() - 1 - n : n;
        return extent.offset(node[0], node[1], node[2]);
    }
};

}  // namespace hexweave
