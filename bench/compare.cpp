// SPDX-License-Identifier: Apache-2.0
// hexweave's solver against those that anyone would pick instead.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "bench/comparison.h"
#include "bench/machine.h"
#include "bench/report.h"
#include "core/parallel.h"

#ifdef HEXWEAVE_BENCH_HYPRE
#include "bench/yardsticks/hypre_picard.h"
#endif

namespace {

constexpr int exit_missing = 3;

int run(hexweave::bench::ComparisonOptions options, bool without_hypre,
        const std::string& json_file) {
    using namespace hexweave::bench;
#ifdef HEXWEAVE_BENCH_HYPRE
    std::optional<HypreSession> session;
    if (!without_hypre) {
        session.emplace();
        options.hypre = hypre_yardsticks();
    }
#else
    if (!without_hypre) {
        fmt::print(stderr,
                   "hypre is not installed: install libhypre-dev, or pass --without-hypre\n");
        return exit_missing;
    }
#endif
    const Comparison comparison = measure_everything(options);
    fmt::print("{}", report_text(comparison));
    if (json_file.empty()) return 0;
    std::ofstream out(json_file);
    out << report_json(comparison) << std::flush;
    if (out) return 0;
    fmt::print(stderr, "could not write {}\n", json_file);
    return exit_missing;
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app("Compares hexweave's elliptic solver with others");
    hexweave::bench::ComparisonOptions options;
    options.program = HEXWEAVE_PROGRAM;
    std::string json_file;
    bool without_hypre = false;
    std::vector<std::string> single;
    app.add_flag("--quick", options.quick, "only the sizes at which ratios are asked");
    app.add_option("--json", json_file, "write everything measured to this file");
    app.add_option("--only", options.only, "one problem: A, B17, W, OO, C, ...");
    app.add_option("--case", single, "PROBLEM NI NJ [NK]: compare on this one case")
        ->expected(3, 4);
    app.add_option("--limit", options.limit, "seconds of one yardstick on one case");
    app.add_flag("--without-hypre", without_hypre, "leave its rows out");
    CLI11_PARSE(app, argc, argv);
    if (!single.empty()) {
        options.single = {single[0],
                          {std::stoi(single[1]), std::stoi(single[2]),
                           single.size() > 3 ? std::stoi(single[3]) : 1}};
    }
    hexweave::set_threads(1);
    hexweave::bench::return_freed_memory();
    return run(options, without_hypre, json_file);
} catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 3;
}
