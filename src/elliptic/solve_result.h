// SPDX-License-Identifier: Apache-2.0
// What a solve came to: returned, never printed and lost.
#pragma once

#include <vector>

namespace hexweave {

enum class SolveStatus {
    algebraic,      ///< nothing was solved, as asked
    converged,      ///< the estimated remaining displacement is below the tolerance
    not_converged,  ///< the iterations ran out; the best iterate was kept
    diverged,       ///< the iterates left the range of numbers; the best iterate was kept
};

struct SolveResult {
    SolveStatus status = SolveStatus::algebraic;
    int iterations = 0;
    double tolerance = 0;         ///< asked, in cells
    double displacement = 0;      ///< of the last step, in cells
    std::vector<double> history;  ///< displacement of every step, in cells
    long folded_before = 0;       ///< folded cells of the start grid
    long folded_after = 0;
};

const char* status_name(SolveStatus status);

}  // namespace hexweave
