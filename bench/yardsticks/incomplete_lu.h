// SPDX-License-Identifier: Apache-2.0
// Incomplete LU factors of the grid operator, without fill: the preconditioner of the linear
// solver. Along a line of strongly coupled nodes, in whichever direction, it is nearly exact, so
// that the thin cells of boundary layers cost nothing extra.
#pragma once

#include <array>
#include <vector>

#include "bench/yardsticks/grid_operator.h"

namespace hexweave::bench {

/// ILU(0) of minus the grid operator with zero boundary values, in the order of the nodes. Kept in
/// single precision: half the memory traffic, and the same number of iterations.
class IncompleteLu {
public:
    explicit IncompleteLu(const NodeLattice& lattice);

    void factor(const Stencils& stencils);
    /// result = (LU)^-1 right_hand_side. The boundary nodes of result must be zero and stay so.
    void solve(const Nodes& right_hand_side, Nodes& result) const;

private:
    NodeLattice lattice_;
    /// 9 or 19 entries per node by ascending offset, the centre's inverted; boundary nodes: zeros,
    /// with which a neighbour's elimination and substitution come to nothing.
    std::vector<float> rows_;
};

}  // namespace hexweave::bench
