// SPDX-License-Identifier: Apache-2.0
// `levels` and `level`: the family of grids that a file describes, and which of them is meant.
#pragma once

#include "topology/case.h"
#include "topology/read_values.h"

namespace hexweave {

/// Reads both into the case. What is faulty is told and left as it is without the key.
void read_levels(Reading& reading, const YamlNode& root, Case& c);

}  // namespace hexweave
