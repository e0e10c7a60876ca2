// SPDX-License-Identifier: Apache-2.0
#include "commands/case_options.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>

#include "commands/case_files.h"
#include "core/parallel.h"
#include "core/processors.h"
#include "io/grid_file.h"
#include "io/output_files.h"
#include "io/output_place.h"
#include "topology/text_limit.h"

namespace hexweave {
namespace {

/// All of it, but of what is longer than a case may be no more than shows that it is.
std::string read_text(std::istream& stream) {
    std::string text(longest_text + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    text.shrink_to_fit();
    return text;
}

void print_errors(const std::string& text) {
    std::fflush(stdout);
    std::fputs(text.c_str(), stderr);
}

/// "2 errors, 1 warning".
std::string tally(const Diagnostics& d) {
    const auto counted = [](int n, const char* what) {
        return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
    };
    const int most = static_cast<int>(Diagnostics::most_kept);
    std::string text =
        d.errors() <= most
            ? counted(d.errors(), "error")
            : fmt::format("more than {} errors: what follows is not looked at", most);
    if (d.warnings() > 0) text += ", " + counted(d.warnings(), "warning");
    return text + "\n";
}

}  // namespace

ExitCode guarded(const std::function<ExitCode()>& body, std::string& failure) {
    const auto failed = [&failure](ExitCode code, const std::string& message) {
        failure = message;
        print_errors("hexweave: error: " + message + "\n");
        return code;
    };
    try {
        return body();
    } catch (const UsageError& e) {
        return failed(ExitCode::wrong_input, e.what());
    } catch (const MachineError& e) {
        return failed(ExitCode::machine_failed, e.what());
    } catch (const std::bad_alloc&) {
        return failed(ExitCode::machine_failed, "out of memory; nothing was written");
    }
}

void add_threads_option(CLI::App& command, int& threads) {
    command
        .add_option("-j,--threads", threads,
                    "threads (default: OMP_NUM_THREADS, else all that this process may use)")
        ->check(CLI::Range(1, 65536))
        ->type_name("N");
}

void write_text(const std::string& text, const std::filesystem::path& path) {
    std::ofstream stream(path, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) cannot_write(path, error_reason(errno));
}

void write_json_text(const std::string& text, const std::string& path) {
    if (path == "-") {
        std::fputs(text.c_str(), stdout);
        return;
    }
    OutputFiles files;
    files.write(files.stage(path),
                [&text](const std::filesystem::path& temporary) { write_text(text, temporary); });
    files.commit();
}

void require_apart(const std::vector<FileUse>& read, const std::string& json) {
    if (json.empty() || json == "-") return;
    require_apart({read, {{json_role, json}}});
}

void add_case_options(CLI::App& command, CaseOptions& options) {
    command.add_option("--set", options.set, "give a parameter another value; may be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME=EXPR");
    command
        .add_option("--level", options.level,
                    "which grid of the family that the config describes, or all of them")
        ->type_name("LEVEL");
    command
        .add_option("--json", options.json, "write the outcome as JSON to this file; - prints it")
        ->type_name("FILE");
    add_threads_option(command, options.threads);
    command.add_flag(
        "--strict", options.strict,
        "treat warnings as errors: exit 2 where the input is warned of, 1 where the grid is");
    CLI::Option* verbose =
        command.add_flag("--verbose", options.verbose, "print every solver step");
    command.add_flag("--quiet", options.quiet, "print nothing but errors")->excludes(verbose);
}

std::string read_whole_file(const std::string& path) {
    const auto refuse = [&path](const char* reason) {
        throw UsageError("cannot read '" + path + "': " + reason);
    };
    if (std::filesystem::is_directory(path)) refuse("it is a folder");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) refuse(std::strerror(errno));
    std::string text = read_text(stream);
    if (stream.bad()) refuse(std::strerror(errno));
    return text;
}

std::shared_ptr<const SourceFile> read_source(const std::string& config) {
    if (config == "-") {
        return std::make_shared<SourceFile>(SourceFile{"<stdin>", read_text(std::cin)});
    }
    std::string text = read_whole_file(config);
    if (begins_as_cgns(text)) {
        throw UsageError(
            fmt::format("'{0}' is a grid, not a config; 'hexweave quality {0}' judges it", config));
    }
    return std::make_shared<SourceFile>(SourceFile{config, std::move(text)});
}

std::vector<Override> parse_overrides(const std::vector<std::string>& set) {
    std::vector<Override> overrides;
    for (const std::string& text : set) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
            throw UsageError("--set takes NAME=EXPR, not '" + text + "'");
        }
        overrides.push_back({text.substr(0, equals), text.substr(equals + 1)});
    }
    return overrides;
}

void settle_warnings(const Diagnostics& diagnostics, const CaseOptions& options) {
    if (diagnostics.warnings() == 0) return;
    if (options.strict) {
        Diagnostics errors;
        for (const Diagnostic& d : diagnostics.all()) {
            Diagnostic& e =
                errors.error(d.place, d.message + " (an error because of --strict)", d.hint);
            e.notes = d.notes;
        }
        throw InputError(errors);
    }
    if (!options.quiet) print_errors(render(diagnostics));
}

ExitCode run_case_command(const char* command, const CaseOptions& options,
                          const std::function<ExitCode(Outcome&)>& body) {
    set_threads(choose_threads(options.threads));
    Outcome outcome;
    outcome.command = command;
    outcome.config = options.config;
    ExitCode code = guarded(
        [&] {
            try {
                require_apart({{{"the config", options.config}}, {}}, options, outcome);
                return body(outcome);
            } catch (const InputError& e) {
                outcome.diagnostics = e.diagnostics;
                print_errors(render(e.diagnostics) + tally(e.diagnostics));
                return ExitCode::wrong_input;
            }
        },
        outcome.failure);
    outcome.exit_code = static_cast<int>(code);
    if (!options.json.empty() && !outcome.json_refused) {
        const ExitCode written = guarded(
            [&] {
                write_json_text(to_json(outcome), options.json);
                return ExitCode::done;
            },
            outcome.failure);
        if (written != ExitCode::done) code = written;
    }
    return code;
}

}  // namespace hexweave
