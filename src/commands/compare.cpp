// SPDX-License-Identifier: Apache-2.0
// `hexweave compare NEW GOLDEN`: are two grids the same?
#include "commands/compare.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

#include "commands/case_options.h"
#include "commands/command.h"
#include "core/parallel.h"
#include "core/processors.h"
#include "io/cgns_pieces.h"
#include "io/comparison_json.h"
#include "io/comparison_text.h"
#include "io/grid_file.h"

namespace hexweave {
namespace {

struct CompareOptions {
    std::string candidate;
    std::string golden;
    double tolerance = 1e-4;
    std::string match = "name";
    std::string json;
    int threads = 0;
    bool quiet = false;
};

/// For a config or a Plot3D file throws UsageError that says how to get a file to compare.
void require_cgns(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    const bool is_named = format_of_ending(ending) || ending == ".yaml" || ending == ".yml";
    if (!is_named || format_to_read(path) == GridFormat::cgns) return;
    throw UsageError(
        fmt::format("cannot compare '{}': it is no CGNS file; 'hexweave convert' makes "
                    "one of a Plot3D file",
                    path.string()));
}

ExitCode compare(const CompareOptions& options, ComparisonOutcome& outcome) {
    if (!(options.tolerance > 0) || !std::isfinite(options.tolerance)) {
        throw UsageError("--tolerance takes a part of a cell, a number above 0");
    }
    outcome.comparison = compare_files(options.candidate, options.golden,
                                       {options.tolerance, options.match == "geometry"});
    std::FILE* out = options.json == "-" ? stderr : stdout;
    if (!options.quiet) fmt::print(out, "{}", to_text(*outcome.comparison));
    fmt::print(out, "{}\n", verdict(*outcome.comparison));
    return outcome.comparison->same() ? ExitCode::done : ExitCode::not_sound;
}

ExitCode compare_and_record(const CompareOptions& options) {
    set_threads(choose_threads(options.threads));
    require_apart({{"the grid", options.candidate}, {"the golden grid", options.golden}},
                  options.json);
    ComparisonOutcome outcome;
    outcome.candidate = options.candidate;
    outcome.golden = options.golden;
    ExitCode code = guarded([&] { return compare(options, outcome); }, outcome.failure);
    outcome.exit_code = static_cast<int>(code);
    if (options.json.empty()) return code;
    std::string ignored;
    const ExitCode written = guarded(
        [&] {
            write_json_text(to_json(outcome), options.json);
            return ExitCode::done;
        },
        ignored);
    return written == ExitCode::done ? code : written;
}

}  // namespace

GridComparison compare_files(const std::string& candidate, const std::string& golden,
                             const ComparisonOptions& options) {
    // Two pieces of each file are in memory: 48 MB.
    constexpr std::size_t piece_nodes = std::size_t{1} << 19;
    for (const std::string& path : {candidate, golden}) require_cgns(path);
    const PointSource own = open_cgns_pieces(candidate, piece_nodes);
    const PointSource other = open_cgns_pieces(golden, piece_nodes);
    return compare_grids(own, other, options);
}

void add_compare(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand(
        "compare",
        "tell whether a grid is the same as a golden one; exit 0 same, 1 different, 2 "
        "could not compare");
    const auto options = std::make_shared<CompareOptions>();
    command->add_option("NEW", options->candidate, "the grid: a structured CGNS file")->required();
    command->add_option("GOLDEN", options->golden, "what it should be")->required();
    command
        ->add_option("--tolerance", options->tolerance,
                     "how far a point may be off, as a part of the shortest edge that meets there")
        ->type_name("CELLS")
        ->capture_default_str();
    command
        ->add_option("--match", options->match,
                     "name: zones of the same name; geometry: zones of the same shape, under "
                     "renaming, reordering and re-orientation of axes")
        ->check(CLI::IsMember({"name", "geometry"}))
        ->capture_default_str();
    command
        ->add_option("--json", options->json,
                     "write the comparison as JSON to this file; - prints it")
        ->type_name("FILE");
    add_threads_option(*command, options->threads);
    command->add_flag("--quiet", options->quiet, "print the verdict only");
    command->footer(
        "\nExit codes: 0 the same within tolerance; 1 different; 2 they could not be compared, or "
        "the\n"
        "command line is wrong; 3 the machine failed.");
    command->callback(
        [options, &chosen] { chosen = [options] { return compare_and_record(*options); }; });
}

}  // namespace hexweave
