// SPDX-License-Identifier: Apache-2.0
#include "commands/command_suggestion.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/diagnostics.h"

namespace hexweave {
namespace {

std::string suggest(const std::string& who, const std::string& kind, const std::string& word,
                    const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), word) != known.end()) return {};
    const std::string meant = nearest_name(word, known);
    if (meant.empty()) return {};
    return fmt::format("{} has no {} '{}'; did you mean '{}'?", who, kind, word, meant);
}

std::vector<std::string> long_options(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

}  // namespace

std::string suggestion_for(const CLI::App& app, const std::vector<std::string>& arguments) {
    if (arguments.empty()) return {};
    std::vector<std::string> commands;
    const CLI::App* command = &app;
    for (const CLI::App* known : app.get_subcommands([](const CLI::App*) { return true; })) {
        commands.push_back(known->get_name());
        if (known->get_name() == arguments[0]) command = known;
    }
    if (command == &app && !arguments[0].starts_with('-')) {
        return suggest("hexweave", "command", arguments[0], commands);
    }
    const std::string who = command == &app ? "hexweave" : "hexweave " + command->get_name();
    for (const std::string& argument : arguments) {
        if (!argument.starts_with("--")) continue;
        const std::string told =
            suggest(who, "option", argument.substr(0, argument.find('=')), long_options(*command));
        if (!told.empty()) return told;
    }
    return {};
}

}  // namespace hexweave
