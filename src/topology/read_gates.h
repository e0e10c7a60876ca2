// SPDX-License-Identifier: Apache-2.0
// `require:` of a file, of a face and of a block.
#pragma once

#include <vector>

#include "topology/gate.h"
#include "topology/read_values.h"

namespace hexweave {

/// The gates under `require` in a mapping; none where the key is not there. Tells limits that every
/// grid, or none, would pass.
std::vector<Gate> read_gates(Reading& reading, const YamlNode& mapping);

}  // namespace hexweave
