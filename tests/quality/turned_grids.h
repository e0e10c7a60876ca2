// SPDX-License-Identifier: Apache-2.0
// Grids whose zones have been renamed, reordered and turned, by index arithmetic of its own.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/multiblock.h"

namespace hexweave::testing {

/// Axis a of the former zone is axis `axis[a]` of the new one, backwards where `reversed[a]`.
struct Turn {
    std::array<int, 3> axis{0, 1, 2};
    std::array<bool, 3> reversed{};
};

/// All 48 turns of a block, all 8 of a face.
std::vector<Turn> all_turns(int cell_dimension);

/// The node that a former node becomes in a zone of former extent `extent`.
Node turned(const Turn& turn, const Node& node, const Extent& extent);

/// The same grid with zone z turned by turns[z].
MultiblockGrid turned(const MultiblockGrid& grid, const std::vector<Turn>& turns);

/// The same grid with its zones in reverse order, under other names, each interface stored on its
/// other side.
MultiblockGrid shuffled(const MultiblockGrid& grid);

/// Two blocks side by side and a third upon them, no two alike, with interfaces, one of them
/// periodic, and boundaries of three families.
MultiblockGrid three_blocks();

/// An O-grid round an ellipse in one zone, joined to itself.
MultiblockGrid ring();

}  // namespace hexweave::testing
