// SPDX-License-Identifier: Apache-2.0
// What may stand at any entry of a section that names things: `when: EXPRESSION`, without which (0)
// the entry is not there, and `repeat: {i: [1, 5]}`, which makes an entry of each value of an
// index.
#pragma once

#include <string_view>

#include "topology/read_values.h"

namespace hexweave {

/// Whether a section of a case is a mapping of names to entries.
bool holds_entries(std::string_view section);

/// Repeats and leaves out the entries of all sections of a case or component as they say. Told are
/// conditions and indices that are no numbers, indices without a name that they make, names made
/// twice, and more entries than a case may have.
void expand_entries(Reading& reading, YamlNode& root);

/// Gives a whole tree the scope that its expressions and names belong to.
void set_scope(YamlNode& node, const std::shared_ptr<InstanceScope>& scope);

}  // namespace hexweave
