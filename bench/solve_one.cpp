// SPDX-License-Identifier: Apache-2.0
// One problem, one solve: what the solver does cycle by cycle.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "bench/measures.h"
#include "bench/pipeline.h"
#include "bench/problems.h"
#include "core/parallel.h"

namespace {

struct Arguments {
    std::string problem;
    hexweave::Extent extent;
    hexweave::EllipticOptions options;
    hexweave::bench::ProblemOptions problem_options;
    bool folded = false;
    int threads = 1;
};

void add_arguments(CLI::App& app, Arguments& a) {
    app.add_option("problem", a.problem, "A, B12 ... B19, Scherk, W, OO or C")->required();
    app.add_option("ni", a.extent.ni, "points along i")->required();
    app.add_option("nj", a.extent.nj, "points along j")->required();
    app.add_option("nk", a.extent.nk, "points along k");
    app.add_option("--cycles", a.options.maximum_cycles, "at most so many");
    app.add_option("--tolerance", a.options.tolerance, "in cells");
    app.add_option("--first-cell", a.problem_options.first_cell, "at the wall");
    app.add_option("--exponent", a.problem_options.flat_edge_exponent,
                   "of edge functions where two sides of a block meet flat");
    app.add_option("--threads", a.threads);
    app.add_flag("--folded", a.folded, "from a start grid folded on purpose");
}

int solve(const Arguments& a) {
    using namespace hexweave;
    auto problem = bench::make_problem(a.problem, a.extent, a.problem_options);
    if (!problem) {
        fmt::print(stderr, "no such problem, or one of its side faces did not converge\n");
        return 2;
    }
    const auto points = static_cast<double>(a.extent.nodes());
    fmt::print("{} {} x {} x {}: {} points, folded at the start {}\n", a.problem, a.extent.ni,
               a.extent.nj, a.extent.nk, points, bench::grid_quality(problem->points).folded);
    const bench::Finished finished = bench::finish(*problem, a.options);
    const SolveResult& result = finished.solve;
    for (std::size_t n = 0; n < result.history.size(); ++n) {
        fmt::print("cycle {:3}: {:.3e} cells\n", n + 1, result.history[n]);
    }
    for (const Safeguard safeguard : result.safeguards) {
        fmt::print("safeguard: {}\n", safeguard_name(safeguard));
    }
    const bench::GridQuality quality = bench::grid_quality(problem->points);
    fmt::print("{}: {} cycles, {:.4f} s, {:.3f} us/point\n", status_name(result.status),
               result.cycles, finished.solve_seconds, 1e6 * finished.solve_seconds / points);
    if (result.untangling) {
        fmt::print("untangled: {} cells were folded, {} points moved, {:.4f} s\n",
                   result.untangling->folded_before, result.untangling->points_moved,
                   finished.untangle_seconds);
    }
    fmt::print("residual {:.2e} cells; folded {}, flat corners {}, min scaled Jacobian {:.3g}\n",
               bench::residual_in_cells(finished.elliptic, problem->parameters), quality.folded,
               quality.flat_corners, quality.least_scaled_jacobian);
    return 0;
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app("Solves one problem of the bench and shows its history");
    Arguments arguments;
    add_arguments(app, arguments);
    CLI11_PARSE(app, argc, argv);
    if (arguments.folded) arguments.problem_options.start = hexweave::bench::Start::folded;
    hexweave::set_threads(arguments.threads);
    return solve(arguments);
} catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 3;
}
