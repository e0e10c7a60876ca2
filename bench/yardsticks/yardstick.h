// SPDX-License-Identifier: Apache-2.0
// The solvers that anyone would pick instead, all behind one call. None shares code with
// src/elliptic.
#pragma once

#include <functional>
#include <string>

#include "bench/problems.h"

namespace hexweave::bench {

/// Called after every outer iteration (every few sweeps) with a function that copies the present
/// grid; false ends the run. `cycles`: outer iterations or sweeps so far.
using Look = std::function<bool(int cycles, const std::function<void(PointField&)>& copy)>;

struct Yardstick {
    std::string family;  ///< "hypre", "SLOR", "ILU-BiCGSTAB"
    std::string name;    ///< "hypre SMG", "SLOR 1.85"
    /// Iterates from the problem's start grid until told to stop.
    std::function<void(const Problem&, const Look&)> run;
};

}  // namespace hexweave::bench
