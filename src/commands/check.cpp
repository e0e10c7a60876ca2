// SPDX-License-Identifier: Apache-2.0
// hexweave check CONFIG: everything but the solving.
#include <fmt/core.h>

#include <memory>
#include <string>
#include <vector>

#include "commands/case_files.h"
#include "commands/case_options.h"
#include "commands/command.h"
#include "commands/level_grids.h"
#include "io/topology_text.h"
#include "topology/explain.h"

namespace hexweave {
namespace {

struct CheckOptions : CaseOptions {
    std::vector<std::string> explain;  ///< names
};

/// What is told of the names that the user asks about.
std::string explanations(const Case& written, const Topology& topology,
                         const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) {
        const std::vector<Explanation> all = explain(written, topology, name);
        if (all.empty()) {
            const std::string meant = nearest_name(name, explained_names(written, topology));
            throw UsageError(
                fmt::format("--explain {}: the grid has no such vertex, edge, face, block, "
                            "boundary or instance{}",
                            name, meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant)));
        }
        for (const Explanation& explanation : all) text += to_text(explanation);
    }
    return text;
}

/// Refuses what `run` would refuse of the files that the grids go to.
void check_outputs(const CheckOptions& options, const Case& written,
                   const std::vector<LevelGrids>& grids, Outcome& outcome) {
    FileUses uses{files_of_case(options, written), {}};
    for (const LevelGrids& part : grids) {
        for (const Topology& topology : part.topologies()) {
            const auto own = files_of_outputs(outputs_of(options, {}, topology), "the grid");
            uses.written.insert(uses.written.end(), own.begin(), own.end());
        }
    }
    require_apart(std::move(uses), options, outcome);
}

ExitCode check(const CheckOptions& options, Outcome& outcome) {
    const Case written = read_case_of(options, outcome);
    const auto grids = resolve_levels(written, options.level, outcome.diagnostics);
    settle_warnings(outcome.diagnostics, options);
    check_outputs(options, written, grids, outcome);
    outcome.parameters = grids.front().solved.parameters;
    std::string text;
    for (const LevelGrids& part : grids) {
        for (const Topology& topology : part.topologies()) {
            outcome.grids.push_back(planned_grid(topology, part.solved));
            if (!text.empty()) text += "\n";
            text += options.explain.empty() ? to_text(topology, part.solved)
                                            : explanations(written, topology, options.explain);
        }
    }
    std::FILE* out = options.json == "-" ? stderr : stdout;
    if (!options.quiet) fmt::print(out, "{}", text);
    return ExitCode::done;
}

}  // namespace

void add_check(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand(
        "check", "read and resolve a config, tell cells and memory; solves and writes nothing");
    auto options = std::make_shared<CheckOptions>();
    command->add_option("CONFIG", options->config, "the YAML file; - reads standard input")
        ->required();
    command
        ->add_option("--explain", options->explain,
                     "tell where the cells, spacing, direction and orientation of this vertex, "
                     "edge, face, block, boundary or instance come from; may be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME");
    add_case_options(*command, *options);
    command->callback([options, &chosen] {
        chosen = [options] {
            return run_case_command("check", *options, [options](Outcome& outcome) {
                return check(*options, outcome);
            });
        };
    });
}

}  // namespace hexweave
