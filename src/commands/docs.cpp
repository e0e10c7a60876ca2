// SPDX-License-Identifier: Apache-2.0
// hexweave docs [KEY...]: the reference of the format.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "commands/command.h"
#include "core/diagnostics.h"
#include "io/format_reference.h"

namespace hexweave {
namespace {

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// The topics whose text holds all these words.
std::vector<std::string> topics_that_speak_of(const std::vector<std::string>& words) {
    std::vector<std::string> found;
    for (const std::string& topic : reference_topics()) {
        const std::string text = lower(format_reference_of(topic));
        if (std::all_of(words.begin(), words.end(), [&](const std::string& word) {
                return text.find(lower(word)) != std::string::npos;
            })) {
            found.push_back(topic);
        }
    }
    return found;
}

ExitCode print_docs(const std::vector<std::string>& words) {
    if (words.empty()) {
        std::fputs(format_reference().c_str(), stdout);
        return ExitCode::done;
    }
    const std::string topic = fmt::format("{}", fmt::join(words, " "));
    const std::string text = format_reference_of(topic);
    if (text.empty()) {
        const std::vector<std::string> found = topics_that_speak_of(words);
        if (!found.empty()) {
            fmt::print("No key is called '{}'; of that speak: {}\n", topic, fmt::join(found, ", "));
            return ExitCode::done;
        }
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
    const auto words = std::make_shared<std::vector<std::string>>();
    command->add_option(
        "KEY", *words,
        "one key or mapping only: edges, spacing, curve circle; or any words, to be "
        "told where they stand");
    command->callback([words, &chosen] { chosen = [words] { return print_docs(*words); }; });
}

}  // namespace hexweave
