// SPDX-License-Identifier: Apache-2.0
#include "elliptic/solve_result.h"

namespace hexweave {

const char* status_name(SolveStatus status) {
    switch (status) {
        case SolveStatus::algebraic:
            return "algebraic";
        case SolveStatus::converged:
            return "converged";
        case SolveStatus::not_converged:
            return "not converged";
        case SolveStatus::diverged:
            return "diverged";
    }
    return "unknown";
}

const char* safeguard_name(Safeguard safeguard) {
    switch (safeguard) {
        case Safeguard::damping:
            return "damping";
        case Safeguard::anderson_picard:
            return "Anderson-Picard";
        case Safeguard::krylov_picard:
            return "Krylov-Picard";
    }
    return "?";
}

const char* orthogonality_end_name(OrthogonalityEnd end) {
    switch (end) {
        case OrthogonalityEnd::all_passes:
            return "all passes done";
        case OrthogonalityEnd::edges_not_converged:
            return "the edge functions did not converge";
        case OrthogonalityEnd::not_converged:
            return "the grid did not converge";
        case OrthogonalityEnd::folded:
            return "the grid is folded";
    }
    return "?";
}

}  // namespace hexweave
