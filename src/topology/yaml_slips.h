// SPDX-License-Identifier: Apache-2.0
// Slips that are valid YAML but mean something else: `cells:4`, `start: 0,5`, `{n: max(4, m)}`. In
// a mapping all of them make a key without a value, which no case has.
#pragma once

#include "core/diagnostics.h"
#include "topology/yaml_tree.h"

namespace hexweave {

/// Tells a slip that made `entry`, a key without a value, and mends what it meant: in the entry
/// itself, or in the value `before` it (null for none) of which it is then a part. Whether it
/// became a part.
bool mend_slip(YamlNode* before, YamlNode& entry, Diagnostics& diagnostics);

/// The same of an item of a list and the one before it: `[max(4, n), 0]`.
bool mend_slip_in_list(YamlNode& before, const YamlNode& item, Diagnostics& diagnostics);

}  // namespace hexweave
