// SPDX-License-Identifier: Apache-2.0
// `hexweave run --golden DIR CONFIG...`: the grids that later ones are compared with.
#pragma once

#include <string>
#include <vector>

#include "commands/case_options.h"

namespace hexweave {

/// Makes the grid of every config and keeps it as DIR/STEM.cgns where there is none yet or where
/// the one there differs; prints how. Nothing is replaced unless all grids are sound: else exit
/// code not_sound. `options.config` is not looked at; one output path per changed golden goes into
/// the outcome, and what is known of the case, which is one where --json is given. Throws
/// UsageError for --json with several.
ExitCode update_goldens(const std::string& folder, const std::vector<std::string>& configs,
                        const CaseOptions& options, Outcome& outcome);

}  // namespace hexweave
