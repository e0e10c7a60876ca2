// SPDX-License-Identifier: Apache-2.0
#include "elliptic/best_iterate.h"

#include "elliptic/fold_count.h"

namespace hexweave {

BestIterate::BestIterate(const PointField& start) : points(start) {
    rank.folded = count_folded(start);
}

void BestIterate::offer(const PointField& grid, double displacement, int after_cycle) {
    const IterateRank offered{count_folded(grid), displacement};
    if (!(offered < rank)) return;
    points = grid;
    rank = offered;
    cycle = after_cycle;
}

}  // namespace hexweave
