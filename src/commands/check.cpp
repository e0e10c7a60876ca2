// SPDX-License-Identifier: Apache-2.0
// hexweave check CONFIG: everything but the solving.
#include <fmt/core.h>

#include <memory>

#include "commands/case_options.h"
#include "commands/command.h"
#include "generate.h"
#include "io/topology_text.h"

namespace hexweave {
namespace {

ExitCode check(const CaseOptions& options, Outcome& outcome) {
    const auto source = read_source(options.config);
    const Topology topology =
        read_topology(source, parse_overrides(options.set), outcome.diagnostics);
    settle_warnings(outcome.diagnostics, options);
    std::FILE* out = options.json == "-" ? stderr : stdout;
    if (!options.quiet) fmt::print(out, "{}", to_text(topology));
    return ExitCode::done;
}

}  // namespace

void add_check(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand(
        "check", "read and resolve a config, tell cells and memory; solves and writes nothing");
    auto options = std::make_shared<CaseOptions>();
    command->add_option("CONFIG", options->config, "the YAML file; - reads standard input")
        ->required();
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
