// SPDX-License-Identifier: Apache-2.0
// Periodic interfaces, and turns about axes, as a file writes them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "topology/case.h"
#include "topology/read_values.h"

namespace hexweave {

/// The turn whose `axis`, `center` and `angle` are keys of a mapping; up to a full turn either way.
std::optional<RotationEntry> read_turn(Reading& reading, const YamlNode& node,
                                       const std::string& what);

/// An entry for every key of `periodic:`, in order; those whose map could not be read are left out.
std::vector<PeriodicEntry> read_periodic(Reading& reading, const YamlNode& section);

}  // namespace hexweave
