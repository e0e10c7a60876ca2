// SPDX-License-Identifier: Apache-2.0
// What is said of a command line that cannot be read, and what its user may have meant.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace hexweave {

/// "hexweave has no command 'rnu'; did you mean 'run'?" for the first argument, and the like for an
/// option of a known command. Empty where every word is known or nothing is near.
std::string suggestion_for(const CLI::App& app, const std::vector<std::string>& arguments);

/// One line for a command line that `app` refused: `suggestion_for` where there is one, else what
/// the parser found, with the help to read.
std::string refusal_of(const CLI::App& app, const std::vector<std::string>& arguments,
                       const CLI::ParseError& found);

}  // namespace hexweave
