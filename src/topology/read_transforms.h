// SPDX-License-Identifier: Apache-2.0
// Scaling, rotation, translation and mirroring of a curve, as a file writes them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/transform.h"
#include "topology/read_values.h"

namespace hexweave {

/// The maps of an entry, in the order in which they apply; nothing after an error. Either the list
/// `transform:`, or one of its maps directly among the entry's keys.
std::optional<std::vector<Affine>> read_transforms(Reading& reading, const YamlNode& entry,
                                                   const std::string& what);

}  // namespace hexweave
