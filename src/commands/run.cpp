// SPDX-License-Identifier: Apache-2.0
// hexweave run CONFIG: the main job.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "commands/case_files.h"
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
#include "io/remarks.h"
#include "io/report_text.h"
#include "io/topology_text.h"

namespace hexweave {
namespace {

struct RunOptions {
    std::vector<std::string> configs;
    CaseOptions input;
    std::vector<std::string> outputs;
    std::string golden;
};

/// One grid that is to be made: its topology, and where it goes; then what came of it.
struct PlannedOutput {
    Topology topology;
    std::vector<ReservedOutput> reserved;
    Report report{};
    std::vector<OffenderFile> offenders{};
};

/// Plans every level; notes in `written` which files it takes.
std::vector<PlannedOutput> plan_levels(const RunOptions& options, const LevelGrids& grids,
                                       std::vector<FileUse>& written) {
    std::vector<PlannedOutput> planned;
    for (Topology& topology : grids.topologies()) {
        const auto outputs = outputs_of(options.input, options.outputs, topology);
        if (outputs.empty()) {
            throw UsageError(
                "a config from standard input needs -o FILE or `output: {cgns: FILE}`");
        }
        const auto uses = files_of_outputs(outputs, options.outputs.empty() ? "the grid" : "-o");
        written.insert(written.end(), uses.begin(), uses.end());
        PlannedOutput& own = planned.emplace_back();
        own.topology = std::move(topology);
        for (const GridOutput& output : outputs) own.reserved.push_back({output, {}});
    }
    return planned;
}

/// Where every grid goes; what cannot be written there is told before the work.
std::vector<std::vector<PlannedOutput>> reserve_outputs(const RunOptions& options,
                                                        const CaseGrids& all, Outcome& outcome,
                                                        OutputFiles& files) {
    FileUses uses{all.read, {}};
    std::vector<std::vector<PlannedOutput>> planned;
    for (const LevelGrids& grids : all.grids) {
        planned.push_back(plan_levels(options, grids, uses.written));
    }
    require_apart(std::move(uses), options.input, outcome);
    for (auto& levels : planned) {
        for (PlannedOutput& own : levels) {
            for (ReservedOutput& place : own.reserved) place = reserve(place.output, files);
        }
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
    // With the JSON on standard output nothing else may stand there.
    std::FILE* out = options.input.json == "-" ? stderr : stdout;
    if (!options.input.quiet) {
        fmt::print(out, "{}{}\n", adjusted_counts_text(made.topology),
                   to_text(made.report, options.input.verbose));
    }
    std::fflush(out);
    for (const Remark& remark : remarks(made.report)) {
        if (remark.is_warning) fmt::print(stderr, "{}", to_text(remark));
    }
    if (!options.input.quiet) {
        fmt::print(out, "{}\n{}", verdict(made.report), where_to_look);
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
    const CaseGrids all = read_grids(options.input, outcome);
    OutputFiles files;
    std::vector<std::vector<PlannedOutput>> planned = reserve_outputs(options, all, outcome, files);
    std::vector<PlannedOutput> made;
    for (std::size_t n = 0; n < planned.size(); ++n) {
        make_levels(all.grids[n], make_progress(options.input.quiet), files, planned[n]);
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
        const bool warned = options.input.strict && has_warnings(grid.report);
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
