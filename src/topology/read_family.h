// SPDX-License-Identifier: Apache-2.0
// Curves and surfaces are entries of one of several families: which one it is stands as a key.
#pragma once

#include <string>

#include "topology/read_values.h"

namespace hexweave {

/// The key of the one family of `names` that an entry has; empty after an error. `what`: "curve
/// 'wake'".
std::string read_family(Reading& reading, const YamlNode& entry, const std::string& what,
                        const Keys& names);

}  // namespace hexweave
