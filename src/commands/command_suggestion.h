// SPDX-License-Identifier: Apache-2.0
// What a user meant by a command or option that there is not.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace hexweave {

/// "hexweave has no command 'rnu'; did you mean 'run'?" for the first argument, and the like for an
/// option of a known command. Empty where every word is known or nothing is near.
std::string suggestion_for(const CLI::App& app, const std::vector<std::string>& arguments);

}  // namespace hexweave
