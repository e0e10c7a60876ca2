// SPDX-License-Identifier: Apache-2.0
// Which nodes the coarser grids of a hierarchy leave out: decided once, from the strength of the
// coupling between neighbours.
#pragma once

#include <array>
#include <vector>

#include "elliptic/level.h"

namespace hexweave {

/// For every step from one level to the next coarser one, the axes along which every second node is
/// left out. On a face: all axes that have nodes to spare. In a block: never the axis along which
/// the spacing varies most (in the far field it has the weakest coupling of all, and what is rough
/// along it alone could be seen by no coarse grid), and of the others the one with the shorter
/// cells first, so that the levels below couple alike along both.
/// `least_nodes`: no axis is left with fewer; on a face that is nowhere stretched, with fewer
/// than 5.
std::vector<std::array<bool, 3>> plan_coarsening(const Level& finest, int least_nodes);

}  // namespace hexweave
