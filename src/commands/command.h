// SPDX-License-Identifier: Apache-2.0
// What every command offers to main: a subcommand of the command line, and something to run.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "core/errors.h"

namespace hexweave {

/// Set by the subcommand that the user chose; main calls it after parsing.
using ChosenCommand = std::function<ExitCode()>;

void add_run(CLI::App& app, ChosenCommand& chosen);
void add_check(CLI::App& app, ChosenCommand& chosen);
void add_convert(CLI::App& app, ChosenCommand& chosen);
void add_plot(CLI::App& app, ChosenCommand& chosen);
void add_geometry(CLI::App& app, ChosenCommand& chosen);
void add_compare(CLI::App& app, ChosenCommand& chosen);
void add_quality(CLI::App& app, ChosenCommand& chosen);
void add_report(CLI::App& app, ChosenCommand& chosen);
void add_docs(CLI::App& app, ChosenCommand& chosen);
void add_graph(CLI::App& app, ChosenCommand& chosen);
void add_init(CLI::App& app, ChosenCommand& chosen);
void add_schema(CLI::App& app, ChosenCommand& chosen);

}  // namespace hexweave
