// SPDX-License-Identifier: Apache-2.0
// The configs that `hexweave init` writes: short, commented, and each runs as it is. They are the
// files in starters/, built into the program.
#pragma once

#include <array>
#include <string_view>

namespace hexweave {

namespace starters {

extern const std::string_view airfoil_yaml;  ///< NAME stands for the case's name
extern const std::string_view channel_yaml;
extern const std::string_view pipe_yaml;
extern const std::string_view wing_yaml;

}  // namespace starters

struct StarterConfig {
    std::string_view name;
    std::string_view what;
    std::string_view text;
};

extern const std::array<StarterConfig, 4> starter_configs;

}  // namespace hexweave
