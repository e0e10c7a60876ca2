// SPDX-License-Identifier: Apache-2.0
// Picard iteration with hypre's multigrid solvers as preconditioners of its BiCGSTAB: set up once
// per step, then solved for each component. The one place that names hypre and MPI.
#pragma once

#include <vector>

#include "bench/yardsticks/yardstick.h"

namespace hexweave::bench {

/// Starts hypre (and MPI) on construction and ends it on destruction; one per process.
class HypreSession {
public:
    HypreSession();
    ~HypreSession();
    HypreSession(const HypreSession&) = delete;
    HypreSession& operator=(const HypreSession&) = delete;
};

/// SMG with one relaxation before and after; PFMG with weighted Jacobi, since its red-black
/// relaxation fails on stencils of 9 points in hypre 2.26; BoomerAMG with HMIS coarsening and
/// extended interpolation, the usual settings in 3D.
std::vector<Yardstick> hypre_yardsticks();

}  // namespace hexweave::bench
