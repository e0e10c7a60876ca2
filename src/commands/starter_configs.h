// SPDX-License-Identifier: Apache-2.0
// The configs that `hexweave init` writes: short, commented, and each runs as it is.
#pragma once

#include <array>
#include <string_view>

namespace hexweave {

struct StarterConfig {
    std::string_view name;
    std::string_view what;
    std::string_view text;
};

extern const std::array<StarterConfig, 3> starter_configs;

}  // namespace hexweave
