// SPDX-License-Identifier: Apache-2.0
// The grid lines that cross an interface.
#pragma once

#include <functional>

#include "core/multiblock.h"
#include "core/vec3.h"

namespace hexweave {

/// Calls visit(before, at, behind) for every node of an interface: the node before it in the
/// interface's own zone, the node itself, and the one behind it in the donor. (Across a periodic
/// interface all three are where the donor is: the first one is turned with the interface.)
void for_lines_across(const MultiblockGrid& grid, const Interface& interface,
                      const std::function<void(const Vec3&, const Vec3&, const Vec3&)>& visit);

}  // namespace hexweave
