// SPDX-License-Identifier: Apache-2.0
// hexweave check CONFIG: everything but the solving.
#include <fmt/core.h>

#include <memory>
#include <string>
#include <vector>

#include "commands/case_options.h"
#include "commands/command.h"
#include "commands/level_grids.h"
#include "io/topology_text.h"
#include "topology/explain.h"
#include "topology/read_case.h"
#include "topology/resolve.h"

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

ExitCode check(const CheckOptions& options, Outcome& outcome) {
    const Case written =
        read_case(read_source(options.config), parse_overrides(options.set), outcome.diagnostics);
    const auto grids = resolve_levels(written, options.level, outcome.diagnostics);
    settle_warnings(outcome.diagnostics, options);
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
