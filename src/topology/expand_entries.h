// SPDX-License-Identifier: Apache-2.0
// What may stand at any entry of a section that names things: `when: EXPRESSION`, without which (0)
// the entry is not there.
#pragma once

#include <string_view>

#include "topology/read_values.h"

namespace hexweave {

/// Whether a section of a case is a mapping of names to entries.
bool holds_entries(std::string_view section);

/// Takes the entries out of all sections whose `when` does not hold, or is faulty (that is told).
void choose_entries(Reading& reading, YamlNode& root);

}  // namespace hexweave
