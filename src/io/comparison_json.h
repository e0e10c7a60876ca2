// SPDX-License-Identifier: Apache-2.0
// A comparison of two grids as scripts read it: a documented, versioned schema (docs/json.md).
#pragma once

#include <optional>
#include <string>

#include "quality/grid_comparison.h"

namespace hexweave {

/// How `hexweave compare` ended.
struct ComparisonOutcome {
    std::string candidate;  ///< the files as they were named
    std::string golden;
    int exit_code = 0;
    std::string failure;  ///< why there is no comparison
    std::optional<GridComparison> comparison;
};

std::string to_json(const ComparisonOutcome& outcome);

}  // namespace hexweave
