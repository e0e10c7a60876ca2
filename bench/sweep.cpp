// SPDX-License-Identifier: Apache-2.0
// A sweep over shapes on which grids fold: wing, wake and O-O blocks with 180-degree edges, from
// mild to extreme first cells. Not one folded cell may be left.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/measures.h"
#include "bench/pipeline.h"
#include "bench/wing_blocks.h"
#include "core/parallel.h"

namespace {

using namespace hexweave;
using namespace hexweave::bench;

struct SweepCase {
    std::string family;
    std::string name;
    std::function<std::optional<Problem>()> make;
};

struct Outcome {
    bool sound = false;        ///< the sides and the solve converged
    long folded_by_solve = 0;  ///< before untangling
    GridQuality quality;
};

struct FamilySum {
    int cases = 0;
    int unsound = 0;
    int folded_cases_by_solve = 0;
    long folded_by_solve = 0;
    long folded = 0;
    double least_scaled_jacobian = 1;
};

std::vector<SweepCase> wing_cases(double exponent) {
    std::vector<SweepCase> cases;
    for (const int points : {25, 33}) {
        for (const double first_cell : {1e-3, 1e-5, 1e-7}) {
            for (const double tip_cell : {5e-4, 3e-3, 2e-2}) {
                for (const double far : {3.0, 15.0}) {
                    for (const Tip tip : {Tip::revolved, Tip::elliptic}) {
                        const WingGrid grid{points, first_cell, tip_cell, tip, far, exponent};
                        const std::string name =
                            fmt::format("{}^3, first cell {:.0e}, tip cell {:.0e}, {} tip, far {}",
                                        points, first_cell, tip_cell,
                                        tip == Tip::revolved ? "revolved" : "elliptic", far);
                        cases.push_back({"wing", name, [=] { return wing_block(grid); }});
                        if (tip == Tip::revolved) {
                            cases.push_back({"wake", name, [=] { return wake_block(grid); }});
                        }
                    }
                }
            }
        }
    }
    return cases;
}

std::vector<SweepCase> all_cases(double exponent) {
    std::vector<SweepCase> cases = wing_cases(exponent);
    for (const int points : {25, 33}) {
        for (const double first_cell : {1e-3, 1e-5, 1e-7}) {
            const ProblemOptions options{Start::transfinite, first_cell, exponent};
            const Extent extent{points, points, points};
            cases.push_back({"O-O", fmt::format("{}^3, first cell {:.0e}", points, first_cell),
                             [=] { return make_problem("OO", extent, options); }});
        }
    }
    return cases;
}

Outcome run(const SweepCase& c) {
    Outcome outcome;
    auto problem = c.make();
    if (!problem) return outcome;
    const Finished finished = finish(*problem, {});
    outcome.sound = finished.solve.status == SolveStatus::converged;
    outcome.quality = grid_quality(problem->points);
    outcome.folded_by_solve = finished.folded_by_solve();
    return outcome;
}

void add(FamilySum& sum, const Outcome& outcome) {
    ++sum.cases;
    sum.unsound += outcome.sound ? 0 : 1;
    sum.folded_cases_by_solve += outcome.folded_by_solve > 0 ? 1 : 0;
    sum.folded_by_solve += outcome.folded_by_solve;
    sum.folded += outcome.quality.folded;
    sum.least_scaled_jacobian =
        std::min(sum.least_scaled_jacobian, outcome.quality.least_scaled_jacobian);
}

/// Prints a line per family and one per case that is not as it should be; whether all are.
bool sweep(double exponent, bool verbose) {
    const std::vector<SweepCase> cases = all_cases(exponent);
    std::vector<Outcome> outcomes(cases.size());
    parallel_for(cases.size(), [&](std::size_t n) { outcomes[n] = run(cases[n]); });
    bool good = true;
    fmt::print("exponent {} where sides meet flat\n", exponent);
    for (const std::string family : {"wing", "wake", "O-O"}) {
        FamilySum sum;
        for (std::size_t n = 0; n < cases.size(); ++n) {
            if (cases[n].family != family) continue;
            const Outcome& outcome = outcomes[n];
            add(sum, outcome);
            const bool case_good = outcome.sound && outcome.quality.folded == 0;
            if (verbose || !case_good) {
                fmt::print("  {} {}: {}folded {} -> {}, min scaled Jacobian {:.2g}\n", family,
                           cases[n].name, outcome.sound ? "" : "not converged, ",
                           outcome.folded_by_solve, outcome.quality.folded,
                           outcome.quality.least_scaled_jacobian);
            }
            good = good && case_good;
        }
        fmt::print(
            "{}: {} cases, {} not converged; folded after the solve {} cells in {} cases, "
            "at the end {}; min scaled Jacobian {:.2g}\n",
            family, sum.cases, sum.unsound, sum.folded_by_solve, sum.folded_cases_by_solve,
            sum.folded, sum.least_scaled_jacobian);
    }
    return good;
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app("Solves wing, wake and O-O blocks over a range of shapes and looks for folds");
    std::vector<double> exponents{1, 0.7};
    bool verbose = false;
    int threads = 1;
    app.add_option("--exponent", exponents, "of edge functions where sides meet flat");
    app.add_option("--threads", threads);
    app.add_flag("--verbose", verbose, "a line per case");
    CLI11_PARSE(app, argc, argv);
    set_threads(threads);
    bool good = true;
    for (const double exponent : exponents) good = sweep(exponent, verbose) && good;
    return good ? 0 : 1;
} catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 3;
}
