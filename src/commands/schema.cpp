// SPDX-License-Identifier: Apache-2.0
// hexweave schema: the format as a JSON Schema.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "commands/command.h"
#include "io/format_schema.h"

namespace hexweave {

void add_schema(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand(
        "schema", "print the JSON Schema (2020-12) of configs, for editors and programs");
    command->footer(
        "An editor with the YAML language server completes and checks a config that begins with\n"
        "  # yaml-language-server: $schema=hexweave.schema.json\n"
        "after hexweave schema > hexweave.schema.json");
    command->callback([&chosen] {
        chosen = [] {
            std::fputs(format_schema().c_str(), stdout);
            return ExitCode::done;
        };
    });
}

}  // namespace hexweave
