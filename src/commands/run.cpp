// SPDX-License-Identifier: Apache-2.0
// hexweave run CONFIG: the main job.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "commands/case_options.h"
#include "commands/command.h"
#include "commands/golden.h"
#include "commands/level_grids.h"
#include "commands/progress.h"
#include "generate.h"
#include "io/grid_file.h"
#include "io/level_text.h"
#include "io/offender_files.h"
#include "io/output_files.h"
#include "io/report_text.h"
#include "io/topology_text.h"
#include "topology/levels.h"

namespace hexweave {
namespace {

struct RunOptions {
    std::vector<std::string> configs;
    CaseOptions input;
    std::vector<std::string> outputs;
    std::string golden;
};

/// Where the grid goes: -o, else the file's `output`, else the config's stem.
std::vector<GridOutput> outputs_of(const RunOptions& options, const Topology& topology) {
    if (options.outputs.empty() && !topology.outputs.empty()) return topology.outputs;
    std::vector<GridOutput> outputs;
    if (options.outputs.empty() && options.input.config == "-") {
        throw UsageError("a config from standard input needs -o FILE or `output: {cgns: FILE}`");
    }
    std::vector<std::string> paths = options.outputs;
    if (paths.empty()) {
        paths = {std::filesystem::path(options.input.config).stem().string() + ".cgns"};
    }
    for (const std::string& path : paths) {
        const auto output = output_by_name(path);
        if (!output) throw UsageError(unknown_ending("write", path));
        outputs.push_back(*output);
    }
    return outputs;
}

/// One grid that is to be made: its topology, and where it goes; then what came of it.
struct PlannedOutput {
    Topology topology;
    std::vector<ReservedOutput> reserved;
    Report report{};
    std::vector<OffenderFile> offenders{};
};

/// Reserves the files of every level, before the work: a folder that cannot be written is told at
/// once. A level named on the command line is told in the names of files that are not.
std::vector<PlannedOutput> reserve_outputs(const RunOptions& options, const LevelGrids& grids,
                                           OutputFiles& files) {
    const std::string& asked = options.input.level;
    const bool name_levels = asked == every_level || (!asked.empty() && options.outputs.empty());
    std::vector<PlannedOutput> planned;
    for (Topology& topology : grids.topologies()) {
        PlannedOutput& own = planned.emplace_back();
        for (const GridOutput& output : outputs_of(options, topology)) {
            const auto& family = topology.family;
            own.reserved.push_back(reserve(
                name_levels ? output_of_level(output, family->names[family->level]) : output,
                files));
        }
        own.topology = std::move(topology);
    }
    return planned;
}

/// Solves once, and writes each level of it to its reserved places.
void make_levels(const LevelGrids& grids, const Progress& progress, OutputFiles& files,
                 std::vector<PlannedOutput>& planned) {
    const Solved solved = solve(grids.solved, progress);
    for (std::size_t n = 0; n < planned.size(); ++n) {
        PlannedOutput& own = planned[n];
        Generated made = grids.levels.empty() ? finish(grids.solved, solved)
                                              : finish(grids.solved, solved, grids.levels[n]);
        for (const ReservedOutput& output : own.reserved) write_grid(made.grid, output, files);
        own.offenders = write_offenders(made.offenders, made.grid.units,
                                        own.reserved.front().output.path, files);
        own.report = std::move(made.report);
    }
}

void print(const RunOptions& options, const PlannedOutput& made) {
    const std::string where_to_look = offender_lines(made.offenders);
    fmt::print(stderr, "{}", cautions(made.report));
    // With the JSON on standard output nothing else may stand there.
    std::FILE* out = options.input.json == "-" ? stderr : stdout;
    if (!options.input.quiet) {
        fmt::print(out, "{}{}\n{}\n{}", adjusted_counts_text(made.topology),
                   to_text(made.report, options.input.verbose), verdict(made.report),
                   where_to_look);
    } else if (!made.report.sound()) {
        std::vector<std::string> paths;
        for (const ReservedOutput& output : made.reserved) paths.push_back(output.output.path);
        fmt::print(stderr, "{}: {}\n{}", fmt::join(paths, ", "), verdict(made.report),
                   where_to_look);
    }
}

/// What was made, as programs read it.
void note(const std::vector<PlannedOutput>& made, Outcome& outcome) {
    for (const PlannedOutput& grid : made) {
        for (const auto& output : grid.reserved) outcome.outputs.push_back(output.output.path);
        outcome.offenders.insert(outcome.offenders.end(), grid.offenders.begin(),
                                 grid.offenders.end());
        outcome.report = grid.report;
        if (made.size() > 1) outcome.levels.push_back(grid.report);
    }
}

ExitCode run(const RunOptions& options, Outcome& outcome) {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<LevelGrids> grids = read_grids(options.input, outcome);
    OutputFiles files;
    std::vector<std::vector<PlannedOutput>> planned;
    for (const LevelGrids& part : grids) {
        planned.push_back(reserve_outputs(options, part, files));
    }
    std::vector<PlannedOutput> made;
    for (std::size_t n = 0; n < grids.size(); ++n) {
        make_levels(grids[n], make_progress(options.input.quiet), files, planned[n]);
        std::move(planned[n].begin(), planned[n].end(), std::back_inserter(made));
    }
    files.commit();
    note(made, outcome);

    for (const PlannedOutput& grid : made) print(options, grid);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    if (!options.input.quiet) {
        std::FILE* out = options.input.json == "-" ? stderr : stdout;
        if (made.size() > 1) fmt::print(out, "\n{}\n", family_table(outcome.levels));
        fmt::print(out, "wrote {} in {:.2f} s\n", fmt::join(outcome.outputs, ", "), taken.count());
    }
    const bool sound = std::all_of(made.begin(), made.end(), [&](const PlannedOutput& grid) {
        const bool warned = options.input.strict && !grid.report.folded_faces().empty();
        return grid.report.sound() && !warned;
    });
    return sound ? ExitCode::done : ExitCode::not_sound;
}

ExitCode run_or_update(const RunOptions& options, Outcome& outcome) {
    if (!options.golden.empty()) {
        return update_goldens(options.golden, options.configs, options.input, outcome);
    }
    if (options.configs.size() > 1) {
        const std::string& second = options.configs[1];
        if (second.find('=') != std::string::npos) {
            throw UsageError(
                fmt::format("what is '{0}' for? A parameter is set by '--set {0}', "
                            "each with a --set of its own",
                            second));
        }
        throw UsageError(fmt::format(
            "run makes the grid of one config, of several with --golden DIR only: what is '{}' "
            "for? A parameter is set by '--set NAME=VALUE'",
            second));
    }
    return run(options, outcome);
}

}  // namespace

void add_run(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("run", "make the grid that a config describes");
    auto options = std::make_shared<RunOptions>();
    command
        ->add_option("CONFIG", options->configs,
                     "the YAML file; - reads standard input; several with --golden")
        ->required();
    add_case_options(*command, options->input);
    CLI::Option* output =
        command
            ->add_option("-o,--output", options->outputs,
                         "write the grid here (default: what the config says, else its stem); the "
                         "format is told by the ending; may be repeated")
            ->allow_extra_args(false)
            ->type_name("FILE.cgns");
    command
        ->add_option("--golden", options->golden,
                     "write the grid of each config to DIR/STEM.cgns, new or over the one there if "
                     "it differs; to check against it, run and then 'hexweave compare'")
        ->type_name("DIR")
        ->excludes(output);
    command->footer(
        "\nExit codes: 0 done, the grid is sound and passes its gates; 1 it is not or does not (it "
        "is\n"
        "written all the same, but never as a golden grid); 2 the input or the command line is "
        "wrong,\n"
        "nothing written; 3 the machine failed, nothing written.");
    command->callback([options, &chosen] {
        options->input.config = options->configs.front();
        chosen = [options] {
            return run_case_command("run", options->input, [options](Outcome& outcome) {
                return run_or_update(*options, outcome);
            });
        };
    });
}

}  // namespace hexweave
