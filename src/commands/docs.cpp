// SPDX-License-Identifier: Apache-2.0
// hexweave docs [KEY]: the reference of the format.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "commands/command.h"
#include "core/diagnostics.h"
#include "io/format_reference.h"

namespace hexweave {
namespace {

ExitCode print_docs(const std::string& topic) {
    if (topic.empty()) {
        std::fputs(format_reference().c_str(), stdout);
        return ExitCode::done;
    }
    const std::string text = format_reference_of(topic);
    if (text.empty()) {
        const std::string meant = nearest_name(topic, reference_topics());
        throw UsageError(fmt::format("docs {}: the format has no such key{}", topic,
                                     meant.empty() ? "; `hexweave docs case` lists where to begin"
                                                   : fmt::format("; did you mean '{}'?", meant)));
    }
    std::fputs(text.c_str(), stdout);
    return ExitCode::done;
}

}  // namespace

void add_docs(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand(
        "docs", "print the reference of the format (Markdown): every key, type, default, example");
    const auto topic = std::make_shared<std::string>();
    command->add_option("KEY", *topic, "one key or mapping only: edges, spacing, \"curve circle\"");
    command->callback([topic, &chosen] { chosen = [topic] { return print_docs(*topic); }; });
}

}  // namespace hexweave
