// SPDX-License-Identifier: Apache-2.0
// Everything that bench/run measures, as plain data.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/demands.h"
#include "bench/measures.h"
#include "bench/timed_run.h"
#include "bench/whole_run.h"

namespace hexweave::bench {

struct ComparisonOptions {
    bool quick = false;
    double limit = 60;           ///< seconds, of one yardstick on one case
    std::string only;            ///< a problem's name; empty: all
    std::optional<Case> single;  ///< compare on this one, and measure nothing else
    std::string program;
    std::vector<Yardstick> hypre;  ///< empty where hypre is missing
};

/// hexweave and the yardsticks on one case. Of a family with several variants, a later one is
/// stopped when it is slower than the best before it.
struct CaseComparison {
    Case where;
    bool reference_trusted = false;
    double reference_residual = 0;
    std::vector<MethodRun> runs;  ///< hexweave's first
};

/// How many times faster hexweave is than the best of a family, to fine_error.
struct Ratio {
    double value = 0;
    bool at_least = false;  ///< the family's time ran out: the ratio is larger
    bool none = false;      ///< not measured, or every variant diverged
};

/// The run of the family that was first; nothing where the family was not run.
const MethodRun* best_of(const CaseComparison& comparison, const std::string& family);
Ratio ratio_to(const CaseComparison& comparison, const std::string& family);

struct CycleCount {
    Case where;
    std::optional<int> cycles;  ///< to fine_error
    bool reference_trusted = false;
};

struct FoldCheck {
    Case where;
    Start start = Start::transfinite;
    SolveStatus status = SolveStatus::not_converged;
    int cycles = 0;
    double solve_seconds = 0;
    long folded_at_start = 0;
    long folded_by_solve = 0;
    GridQuality after;
    // What untangling did, where it was called for.
    bool untangled = false;
    bool whole_grid = false;
    double untangle_seconds = 0;
    long points_moved = 0;
    double seam_before = 1;  ///< size ratios where points moved
    double seam_after = 1;
};

struct BlockCycle {
    Case where;
    double seconds_per_cycle = 0;
    double triad = 0;  ///< bytes per second
    double seconds_at_bandwidth = 0;
    double seconds_one_thread = 0;
    double seconds_two_threads = 0;
};

struct Comparison {
    std::vector<CaseComparison> cases;
    std::vector<CycleCount> cycle_counts;
    std::vector<FoldCheck> folds;
    std::optional<BlockCycle> block_cycle;
    std::optional<WholeRun> whole_run;
};

/// Takes minutes; says on standard error what it is at.
Comparison measure_everything(const ComparisonOptions& options);

}  // namespace hexweave::bench
