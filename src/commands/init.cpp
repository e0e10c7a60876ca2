// SPDX-License-Identifier: Apache-2.0
// hexweave init NAME: a commented config to begin with.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "commands/command.h"
#include "commands/starter_configs.h"
#include "core/diagnostics.h"
#include "io/output_files.h"
#include "io/picture_drawing.h"

namespace hexweave {
namespace {

struct InitArguments {
    std::string name;
    std::string starter = "airfoil";
};

const StarterConfig& find_starter(const std::string& wanted) {
    std::vector<std::string> names;
    for (const StarterConfig& config : starter_configs) {
        if (config.name == wanted) return config;
        names.emplace_back(config.name);
    }
    const std::string meant = nearest_name(wanted, names);
    throw UsageError(fmt::format("--template {}: there is no such template; {}", wanted,
                                 meant.empty() ? fmt::format("there are {}", fmt::join(names, ", "))
                                               : fmt::format("did you mean '{}'?", meant)));
}

/// The template's text, the case's name in place of NAME.
std::string named(std::string text, const std::string& name) {
    constexpr std::string_view place = "NAME";
    for (std::size_t at = text.find(place); at != std::string::npos;
         at = text.find(place, at + name.size())) {
        text.replace(at, place.size(), name);
    }
    return text;
}

/// As it can be typed: in quotes where a shell would take it apart.
std::string shell_word(const std::string& word) {
    const bool plain = std::all_of(word.begin(), word.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || std::strchr("_-./+,:@%", c) != nullptr;
    });
    if (plain) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

ExitCode init(const InitArguments& arguments) {
    std::filesystem::path path = arguments.name;
    if (path.extension() != ".yaml") path += ".yaml";
    const StarterConfig& starter = find_starter(arguments.starter);
    if (std::filesystem::symlink_status(path).type() != std::filesystem::file_type::not_found) {
        throw UsageError(fmt::format(
            "'{}' exists; it was left as it is: give another name, or remove it", path.string()));
    }
    OutputFiles files;
    files.write(files.stage(path), [&](const std::filesystem::path& temporary) {
        write_bytes(named(std::string(starter.text), path.stem().string()), temporary);
    });
    files.commit();
    fmt::print("wrote {}: {}\nnow:   hexweave run {}\n", path.string(), starter.what,
               shell_word(path.string()));
    return ExitCode::done;
}

}  // namespace

void add_init(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command =
        app.add_subcommand("init", "write a commented config to begin with, NAME.yaml");
    const auto arguments = std::make_shared<InitArguments>();
    command->add_option("NAME", arguments->name, "the config; an existing file is never replaced")
        ->required();
    std::string help = "what it describes:";
    for (const StarterConfig& config : starter_configs) {
        help += fmt::format(" {} ({}),", config.name, config.what);
    }
    help.pop_back();
    command->add_option("--template", arguments->starter, help)->capture_default_str();
    command->callback([arguments, &chosen] { chosen = [arguments] { return init(*arguments); }; });
}

}  // namespace hexweave
