// SPDX-License-Identifier: Apache-2.0
// Sides of a block, and the signed permutations that carry one index space onto another.
// This is the only place where indices are flipped or swapped.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/field.h"

namespace hexweave {

enum class Side { imin, imax, jmin, jmax, kmin, kmax };

inline constexpr std::array<Side, 6> all_sides{Side::imin, Side::imax, Side::jmin,
                                               Side::jmax, Side::kmin, Side::kmax};

/// "imin", "imax", ...
std::string_view side_name(Side side);

/// The axis that a side is constant in: 0 (i), 1 (j) or 2 (k).
constexpr int axis_of(Side side) {
    return static_cast<int>(side) / 2;
}
constexpr bool is_max(Side side) {
    return static_cast<int>(side) % 2 == 1;
}
/// The side's own two axes, ascending: (j, k), (i, k) or (i, j).
constexpr std::array<int, 2> tangential_axes(Side side) {
    return axis_of(side) == 0   ? std::array{1, 2}
           : axis_of(side) == 1 ? std::array{0, 2}
                                : std::array{0, 1};
}

/// A node's indices, zero-based.
using Node = std::array<int, 3>;

/// A signed axis permutation: own axis a runs along axis |axes[a]| (1, 2, 3) of the other index
/// space, backwards when axes[a] is negative. The same triple as the Transform of CGNS 1-to-1
/// connectivity. In a two-dimensional space the third entry is 3.
struct Orientation {
    std::array<int, 3> axes{1, 2, 3};

    friend bool operator==(const Orientation&, const Orientation&) = default;
};

Orientation inverse(const Orientation& o);
/// First `first`, then `second`: own -> middle -> other.
Orientation compose(const Orientation& first, const Orientation& second);
/// +1 for a rotation, -1 for a reflection.
int determinant(const Orientation& o);
/// The node of the other space, of extent `other`, that own node `n` falls on when the two spaces
/// cover each other wholly.
Node map_node(const Orientation& o, const Node& n, const Extent& other);
/// The same when only a part of each space is shared: own node `begin` falls on `other_begin`
/// (Begin1 and Begin2 of CGNS 1-to-1 connectivity).
Node map_node(const Orientation& o, const Node& n, const Node& begin, const Node& other_begin);
/// The extent that own space has when it covers `other` wholly.
Extent own_extent(const Orientation& o, const Extent& other);
/// The eight orientations of a face: third axis kept.
const std::array<Orientation, 8>& face_orientations();
/// "[i, -k, j]", as users write it; two axes for a face.
std::string to_string(const Orientation& o, int axes);

/// A rectangle of nodes, both ends included; begin > end along an axis means running backwards.
struct IndexBox {
    Node begin{};
    Node end{};

    friend bool operator==(const IndexBox&, const IndexBox&) = default;
};

/// The nodes of one whole side.
IndexBox side_box(Side side, const Extent& extent);

}  // namespace hexweave
