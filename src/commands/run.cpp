// SPDX-License-Identifier: Apache-2.0
// hexweave run CONFIG: the main job.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "commands/case_options.h"
#include "commands/command.h"
#include "commands/golden.h"
#include "commands/progress.h"
#include "generate.h"
#include "io/grid_file.h"
#include "io/offender_files.h"
#include "io/output_files.h"
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

ExitCode run(const RunOptions& options, Outcome& outcome) {
    const auto start = std::chrono::steady_clock::now();
    const auto source = read_source(options.input.config);
    const std::vector<Override> overrides = parse_overrides(options.input.set);
    const Topology topology = read_topology(source, overrides, outcome.diagnostics);
    outcome.parameters = topology.parameters;
    settle_warnings(outcome.diagnostics, options.input);
    outcome.grids.push_back(planned_grid(topology));

    // The output is staged before the work: a folder that cannot be written is told at once.
    OutputFiles files;
    std::vector<ReservedOutput> reserved;
    for (const GridOutput& output : outputs_of(options, topology)) {
        reserved.push_back(reserve(output, files));
    }
    const Generated made = generate(topology, make_progress(options.input.quiet));
    outcome.report = made.report;
    for (const ReservedOutput& output : reserved) write_grid(made.grid, output, files);
    std::vector<OffenderFile> offenders =
        write_offenders(made.offenders, made.grid.units, reserved.front().output.path, files);
    files.commit();
    for (const ReservedOutput& output : reserved) outcome.outputs.push_back(output.output.path);
    outcome.offenders = std::move(offenders);
    const std::string written = fmt::format("{}", fmt::join(outcome.outputs, ", "));
    const std::string where_to_look = offender_lines(outcome.offenders);

    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    // With the JSON on standard output nothing else may stand there.
    std::FILE* out = options.input.json == "-" ? stderr : stdout;
    if (!options.input.quiet) {
        fmt::print(out, "{}{}\n", adjusted_counts_text(topology),
                   to_text(made.report, options.input.verbose));
        fmt::print(out, "{}\n{}", verdict(made.report), where_to_look);
        fmt::print(out, "wrote {} in {:.2f} s\n", written, taken.count());
    } else if (!made.report.sound()) {
        fmt::print(stderr, "{}: {}\n{}", written, verdict(made.report), where_to_look);
    }
    return made.report.sound() ? ExitCode::done : ExitCode::not_sound;
}

ExitCode run_or_update(const RunOptions& options, Outcome& outcome) {
    if (!options.golden.empty()) {
        return update_goldens(options.golden, options.configs, options.input, outcome);
    }
    if (options.configs.size() > 1) {
        throw UsageError("run takes one config, several with --golden DIR only");
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
                     "keep the grid of each config as DIR/STEM.cgns, where there is none yet or "
                     "where it differs from the one there")
        ->type_name("DIR")
        ->excludes(output);
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
