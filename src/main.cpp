// SPDX-License-Identifier: Apache-2.0
// argv -> command -> exit code.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "commands/command.h"
#include "commands/command_suggestion.h"
#include "core/errors.h"
#include "io/cgns.h"
#include "io/output_files.h"

namespace {

constexpr const char* description =
    "hexweave: multiblock structured grids for CFD from a declarative text file\n";
constexpr const char* exit_codes =
    "\nExit codes: 0 done; 1 the grid is not sound (run writes it all the same), or differs\n"
    "(compare); 2 the input or the command line is wrong, nothing written; 3 the machine failed,\n"
    "nothing written.";
/// Of a command that judges no grid and says nothing else.
constexpr const char* exit_codes_of_commands =
    "\nExit codes: 0 done; 2 the input or the command line is wrong, nothing written; 3 the\n"
    "machine failed, nothing written.";

int failed(hexweave::ExitCode code, const char* message) {
    std::fprintf(stderr, "hexweave: error: %s\n", message);
    return static_cast<int>(code);
}

/// The command line: parsed into the command that it chooses, which then runs.
int run(int argc, char** argv) {
    using hexweave::ExitCode;
    CLI::App app{description, "hexweave"};
    app.set_version_flag("--version", "hexweave " HEXWEAVE_VERSION);
    app.require_subcommand(1);
    app.footer(exit_codes_of_commands);  // commands take it over when they are added
    hexweave::ChosenCommand chosen;
    hexweave::add_run(app, chosen);
    hexweave::add_check(app, chosen);
    hexweave::add_convert(app, chosen);
    hexweave::add_plot(app, chosen);
    hexweave::add_geometry(app, chosen);
    hexweave::add_compare(app, chosen);
    hexweave::add_quality(app, chosen);
    hexweave::add_report(app, chosen);
    hexweave::add_init(app, chosen);
    hexweave::add_graph(app, chosen);
    hexweave::add_docs(app, chosen);
    hexweave::add_schema(app, chosen);
    app.footer(exit_codes);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        const bool asked_for_text = e.get_exit_code() == 0;
        if (!asked_for_text) {
            const std::vector<std::string> arguments(argv + 1, argv + argc);
            return failed(ExitCode::wrong_input, hexweave::refusal_of(app, arguments, e).c_str());
        }
        app.exit(e);
        return static_cast<int>(ExitCode::done);
    }
    return static_cast<int>(chosen());
}

}  // namespace

int main(int argc, char** argv) {
    using hexweave::ExitCode;
    try {
        hexweave::prepare_hdf5();
        hexweave::remove_staged_files_on_signals();
        return run(argc, argv);
    } catch (const hexweave::UsageError& e) {
        return failed(ExitCode::wrong_input, e.what());
    } catch (const hexweave::MachineError& e) {
        return failed(ExitCode::machine_failed, e.what());
    } catch (const std::bad_alloc&) {
        return failed(ExitCode::machine_failed, "out of memory; nothing was written");
    } catch (const std::exception& e) {
        return failed(ExitCode::machine_failed, e.what());
    }
}
