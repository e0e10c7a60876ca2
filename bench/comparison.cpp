// SPDX-License-Identifier: Apache-2.0
#include "bench/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "bench/machine.h"
#include "bench/pipeline.h"
#include "bench/traffic.h"
#include "bench/yardsticks/picard.h"
#include "bench/yardsticks/slor.h"
#include "core/parallel.h"

namespace hexweave::bench {

namespace {

/// A yardstick is given at least so long, and a little more than what decides a demand.
constexpr double least_limit = 1;
constexpr double margin = 1.1;

/// Where the quick bench tries fewer variants.
constexpr std::size_t many_points = 1'000'000;

/// What the program gives edge functions at 180-degree edges; speed is compared on the paper's own.
constexpr double program_exponent = 0.7;

void say(const std::string& what) {
    fmt::print(stderr, "{}\n", what);
}

std::string name_of(const Case& c) {
    if (c.extent.nk == 1) return fmt::format("{} {}x{}", c.problem, c.extent.ni, c.extent.nj);
    return fmt::format("{} {}x{}x{}", c.problem, c.extent.ni, c.extent.nj, c.extent.nk);
}

/// The wavy cube starts folded, the others from transfinite interpolation.
std::optional<Problem> problem_of(const Case& c) {
    const Start start = c.problem == "C" ? Start::folded : Start::transfinite;
    auto problem = make_problem(c.problem, c.extent, {start});
    if (!problem) say("  no problem: a side face did not converge");
    return problem;
}

/// Relaxation factors in the order of promise.
std::vector<Yardstick> relaxations(bool quick, const Extent& extent) {
    std::vector<double> factors{1.9, 1.8};
    if (extent.nk == 1) {
        factors = quick ? std::vector{1.9, 1.95} : std::vector{1.9, 1.95, 1.97, 1.8, 1.7, 1.5};
    } else if (!quick) {
        factors = {1.85, 1.9, 1.8, 1.7, 1.93, 1.6};
    } else if (extent.nodes() < many_points) {
        factors = {1.85, 1.9, 1.75};
    }
    std::vector<Yardstick> all;
    all.reserve(factors.size());
    for (const double factor : factors) all.push_back(line_relaxation(factor));
    return all;
}

/// Runs the variants of one family; each has to beat those before it.
void run_family(const Problem& problem, const PointField& reference,
                const std::vector<Yardstick>& variants, double limit,
                std::vector<MethodRun>& runs) {
    for (const Yardstick& variant : variants) {
        say(fmt::format("  {}, up to {:.1f} s", variant.name, limit));
        runs.push_back(time_yardstick(problem, reference, variant, limit));
        if (runs.back().to_fine) limit = std::min(limit, runs.back().to_fine->seconds);
    }
}

CaseComparison compare(const Case& where, const Demand* demand, const ComparisonOptions& options) {
    say(name_of(where));
    CaseComparison result;
    result.where = where;
    const auto problem = problem_of(where);
    if (!problem) return result;
    const Reference reference = converged_grid(*problem);
    result.reference_trusted = reference.trusted();
    result.reference_residual = reference.residual;
    say("  hexweave");
    result.runs.push_back(time_own_solver(*problem, reference.points, 3));
    const MethodRun& own = result.runs.front();
    const auto limit = [&](const std::string& family) {
        if (!options.quick || demand == nullptr || !own.to_fine) return options.limit;
        return std::max(least_limit, margin * demand->of(family) * own.to_fine->seconds);
    };
    const std::vector<Yardstick> slor = relaxations(options.quick, where.extent);
    std::vector<Yardstick> hypre = options.hypre;
    if (options.quick && where.extent.nodes() > many_points && !hypre.empty()) hypre.pop_back();
    std::vector<MethodRun> runs;
    run_family(*problem, reference.points, {ilu_picard()}, limit("ILU-BiCGSTAB"), runs);
    run_family(*problem, reference.points, slor, limit("SLOR"), runs);
    run_family(*problem, reference.points, hypre, limit("hypre"), runs);
    std::move(runs.begin(), runs.end(), std::back_inserter(result.runs));
    return result;
}

CycleCount count_cycles(const Case& where) {
    say("cycles of " + name_of(where));
    CycleCount count{where, std::nullopt, false};
    const auto problem = problem_of(where);
    if (!problem) return count;
    const Reference reference = converged_grid(*problem);
    count.reference_trusted = reference.trusted();
    count.cycles = cycles_to(*problem, reference.points, fine_error);
    return count;
}

FoldCheck check_folds(const Case& where, Start start, double exponent) {
    say("folds of " + name_of(where));
    FoldCheck check;
    check.where = where;
    check.start = start;
    auto problem = make_problem(where.problem, where.extent, {start, 0, exponent});
    if (!problem) return check;
    check.folded_at_start = grid_quality(problem->points).folded;
    const Finished finished = finish(*problem, {});
    check.solve_seconds = finished.solve_seconds;
    check.status = finished.solve.status;
    check.cycles = finished.solve.cycles;
    check.folded_by_solve = finished.folded_by_solve();
    check.after = grid_quality(problem->points);
    if (finished.solve.untangling) {
        check.untangled = true;
        check.whole_grid = finished.solve.untangling->whole_grid;
        check.untangle_seconds = finished.untangle_seconds;
        check.points_moved = finished.solve.untangling->points_moved;
        check.seam_before = size_ratio_where_moved(finished.elliptic, problem->points);
        check.seam_after = size_ratio_where_moved(problem->points, finished.elliptic);
    }
    return check;
}

double median_of_three(const Problem& problem, int cycles, Clock clock) {
    return median({time_cycles(problem, cycles, clock), time_cycles(problem, cycles, clock),
                   time_cycles(problem, cycles, clock)});
}

/// The time of a cycle is the difference of runs with more and fewer of them, so that what is done
/// once does not count.
std::optional<BlockCycle> measure_block_cycle(const Case& where, double bytes_per_point) {
    say("a cycle of " + name_of(where));
    constexpr int few = 1;
    constexpr int many = 5;
    const auto problem = problem_of(where);
    if (!problem) return std::nullopt;
    BlockCycle cycle;
    cycle.where = where;
    const auto points = static_cast<double>(where.extent.nodes());
    cycle.triad = triad_bandwidth(static_cast<std::size_t>(points * bytes_per_point));
    cycle.seconds_at_bandwidth = points * block_cycle_bytes_per_point / cycle.triad;
    cycle.seconds_per_cycle = (median_of_three(*problem, many, Clock::processor) -
                               median_of_three(*problem, few, Clock::processor)) /
                              (many - few);
    cycle.seconds_one_thread = median_of_three(*problem, many, Clock::wall);
    set_threads(2);
    cycle.seconds_two_threads = median_of_three(*problem, many, Clock::wall);
    set_threads(1);
    return cycle;
}

std::vector<FoldCheck> check_all_folds(const ComparisonOptions& options) {
    std::vector<FoldCheck> checks;
    for (const Case& where : fold_cases) {
        if (!options.only.empty() && options.only != where.problem) continue;
        for (const Start start : {Start::transfinite, Start::folded}) {
            checks.push_back(check_folds(where, start, program_exponent));
        }
        // The paper's own edge functions fold there: untangling has to cure that too.
        if (where.problem == "OO") checks.push_back(check_folds(where, Start::transfinite, 1));
    }
    return checks;
}

/// Working memory of the solver per point, where it was measured.
double bytes_of_own(const Comparison& comparison) {
    double bytes = 0;
    for (const CaseComparison& c : comparison.cases) {
        if (c.where.extent == large_block.extent && !c.runs.empty()) {
            bytes = c.runs.front().bytes_per_point;
        }
    }
    return bytes > 0 ? bytes : 150;
}

}  // namespace

const MethodRun* best_of(const CaseComparison& comparison, const std::string& family) {
    const MethodRun* best = nullptr;
    const auto rank = [](const MethodRun& run) {
        // Those that arrived, then those whose time ran out (the longest bound first), then those
        // that diverged.
        if (run.to_fine) return std::pair{0, run.to_fine->seconds};
        return std::pair{run.diverged ? 2 : 1, run.seconds};
    };
    for (const MethodRun& run : comparison.runs) {
        if (run.family == family && (best == nullptr || rank(run) < rank(*best))) best = &run;
    }
    return best;
}

Ratio ratio_to(const CaseComparison& comparison, const std::string& family) {
    const MethodRun* own = best_of(comparison, "hexweave");
    const MethodRun* other = best_of(comparison, family);
    if (own == nullptr || !own->to_fine || other == nullptr || other->diverged) {
        return {0, false, true};
    }
    const double seconds = other->to_fine ? other->to_fine->seconds : other->seconds;
    return {seconds / own->to_fine->seconds, !other->to_fine, false};
}

Comparison measure_everything(const ComparisonOptions& options) {
    const auto wanted = [&](const Case& c) {
        return options.only.empty() || options.only == c.problem;
    };
    Comparison all;
    if (options.single) {
        all.cases.push_back(compare(*options.single, nullptr, options));
        return all;
    }
    // First, while this process is small: its own image counts for nothing in the other's peak.
    if (options.only.empty()) {
        say("a whole run of the program");
        all.whole_run = measure_whole_run(options.program);
    }
    for (const Demand& demand : demands) {
        if (wanted(demand.where)) all.cases.push_back(compare(demand.where, &demand, options));
    }
    if (!options.quick) {
        for (const Case& where : further_cases) {
            if (wanted(where)) all.cases.push_back(compare(where, nullptr, options));
        }
    }
    for (const Case& where : cycle_cases) {
        if (wanted(where)) all.cycle_counts.push_back(count_cycles(where));
    }
    all.folds = check_all_folds(options);
    if (wanted(large_block)) {
        all.block_cycle = measure_block_cycle(large_block, bytes_of_own(all));
    }
    return all;
}

}  // namespace hexweave::bench
