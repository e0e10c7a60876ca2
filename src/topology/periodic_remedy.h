// SPDX-License-Identifier: Apache-2.0
// The map that a periodic interface would have to have.
#pragma once

#include <string>
#include <vector>

#include "topology/draft.h"

namespace hexweave {

/// What to write for the map of an interface so that every side of `from` has its image among those
/// of `to`: another vector, or another angle about the same axis. Empty where none does.
std::string map_that_pairs(const Network& network, const PeriodicEntry& entry,
                           const std::vector<int>& from, const std::vector<int>& to);

}  // namespace hexweave
