// SPDX-License-Identifier: Apache-2.0
#include "commands/command_suggestion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/diagnostics.h"

namespace hexweave {
namespace {

std::string suggest(const std::string& who, const std::string& kind, const std::string& word,
                    const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), word) != known.end()) return {};
    const auto longer = std::find_if(known.begin(), known.end(), [&word](const auto& name) {
        return word.size() > 3 && name.starts_with(word);
    });
    const std::string meant = longer != known.end() ? *longer : nearest_name(word, known);
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

bool is_config(const std::string& name) {
    return name.ends_with(".yaml") || name.ends_with(".yml");
}

/// The option that takes one value and was given several; empty for any other fault.
std::string given_twice(const CLI::ParseError& found) {
    const std::string what = found.what();
    const std::size_t at = what.find(": At Most 1 required");
    const bool is_mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&found) != nullptr;
    return is_mismatch && at != std::string::npos ? what.substr(0, at) : "";
}

const CLI::App* command_named(const CLI::App& app, const std::string& name) {
    for (const CLI::App* known : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (known->get_name() == name) return known;
    }
    return nullptr;
}

}  // namespace

std::string suggestion_for(const CLI::App& app, const std::vector<std::string>& arguments) {
    if (arguments.empty()) return {};
    const CLI::App* command = command_named(app, arguments[0]);
    if (command == nullptr && !arguments[0].starts_with('-')) {
        if (is_config(arguments[0])) {
            return fmt::format("the command is missing: did you mean 'hexweave run {}'?",
                               arguments[0]);
        }
        std::vector<std::string> commands;
        for (const CLI::App* known : app.get_subcommands([](const CLI::App*) { return true; })) {
            commands.push_back(known->get_name());
        }
        return suggest("hexweave", "command", arguments[0], commands);
    }
    if (command == nullptr) command = &app;
    const std::string who = command == &app ? "hexweave" : "hexweave " + command->get_name();
    for (const std::string& argument : arguments) {
        if (!argument.starts_with("--")) continue;
        std::string told =
            suggest(who, "option", argument.substr(0, argument.find('=')), long_options(*command));
        if (!told.empty()) return told;
    }
    return {};
}

std::string refusal_of(const CLI::App& app, const std::vector<std::string>& arguments,
                       const CLI::ParseError& found) {
    std::string meant = suggestion_for(app, arguments);
    if (!meant.empty()) return meant;
    const CLI::App* command = arguments.empty() ? nullptr : command_named(app, arguments[0]);
    const std::string who = command == nullptr ? "hexweave" : "hexweave " + command->get_name();
    std::string what = found.what();
    if (dynamic_cast<const CLI::ExtrasError*>(&found) != nullptr) {
        // The parser's own words turn their order round.
        what = fmt::format("cannot tell what '{}' is for", fmt::join(app.remaining(true), " "));
    } else if (const std::string twice = given_twice(found); !twice.empty()) {
        what = twice + " is given twice";
    } else if (dynamic_cast<const CLI::RequiredError*>(&found) != nullptr && command == nullptr) {
        what = arguments.empty() ? "a command is missing, such as run, check or quality"
                                 : fmt::format("there is no command '{}'", arguments[0]);
    }
    return fmt::format("{}; see '{} --help'", what, who);
}

}  // namespace hexweave
