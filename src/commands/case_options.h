// SPDX-License-Identifier: Apache-2.0
// What `run` and `check` share: the config and its overrides, where diagnostics go, and the JSON.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "core/errors.h"
#include "io/file_uses.h"
#include "io/report_json.h"
#include "topology/read_case.h"

namespace hexweave {

struct CaseOptions {
    std::string config;            ///< "-" reads standard input
    std::vector<std::string> set;  ///< NAME=EXPR
    std::string level;             ///< of a family of grids, or "all"; empty: what the config says
    std::string json;              ///< "-" writes standard output; empty: none
    int threads = 0;               ///< 0: OMP_NUM_THREADS or all
    bool strict = false;
    bool verbose = false;
    bool quiet = false;
};

/// What its file is called in messages.
inline constexpr const char* json_role = "--json";

/// Adds --set, --level, -j, --json, --strict, --verbose and --quiet to a subcommand.
void add_case_options(CLI::App& command, CaseOptions& options);

/// The text of a file, or as much as shows that it is too long for a case. Throws UsageError when
/// it cannot be read.
std::string read_whole_file(const std::string& path);

/// The config's text. Throws UsageError when it cannot be read, or is a grid.
std::shared_ptr<const SourceFile> read_source(const std::string& config);

/// -j, --threads: 0 where it is not given, for choose_threads.
void add_threads_option(CLI::App& command, int& threads);

/// Writes a whole file (stage it with OutputFiles first). Throws MachineError.
void write_text(const std::string& text, const std::filesystem::path& path);

/// Writes a text that is JSON to a file; "-" prints it.
void write_json_text(const std::string& text, const std::string& path);

/// Refuses the file of --json as require_apart of io/file_uses.h, where there is one.
void require_apart(const std::vector<FileUse>& read, const std::string& json);

/// Runs a body and turns every failure into its message, on standard error and in `failure`, and
/// its exit code: wrong_input for a UsageError, machine_failed for the machine's failures.
ExitCode guarded(const std::function<ExitCode()>& body, std::string& failure);

/// Splits NAME=EXPR. Throws UsageError for anything else.
std::vector<Override> parse_overrides(const std::vector<std::string>& set);

/// Runs the body of a command and turns every failure into its exit code: input errors are printed
/// and give wrong_input, the machine's failures machine_failed. With --strict, warnings are errors.
/// The body fills the outcome; the JSON is written whatever happens.
ExitCode run_case_command(const char* command, const CaseOptions& options,
                          const std::function<ExitCode(Outcome&)>& body);

/// With --strict, throws InputError when there are warnings; else prints them to standard error.
void settle_warnings(const Diagnostics& diagnostics, const CaseOptions& options);

}  // namespace hexweave
