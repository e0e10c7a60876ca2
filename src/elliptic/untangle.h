// SPDX-License-Identifier: Apache-2.0
// The last safeguard after a solve: folded cells are unfolded where they are.
#pragma once

#include <functional>
#include <optional>

#include "core/field.h"
#include "elliptic/solve_result.h"

namespace hexweave {

/// Turns folded cells (as fold_count.h defines them) the right way round by minimizing the
/// regularised functional of Garanzha et al. (Foldover-free maps in 50 lines of code, ACM
/// Transactions on Graphics 40, 2021) on patches round them, towards their own cells sheared back;
/// where that fails on larger patches; then with all interior nodes free, from the grid as it is,
/// and last from the `transfinite` grid (asked for only then; of the same boundary). Nothing
/// when no cell is folded. Boundary nodes, and all nodes outside patches, keep their bits. A part
/// of the grid is changed only where the number of its folded cells fell. Cells that boundary nodes
/// alone fold are left; whether any are left is for count_folded to tell. Work is bounded. The same
/// for any number of threads.
std::optional<Untangling> untangle(PointField& points,
                                   const std::function<PointField()>& transfinite);

}  // namespace hexweave
