// SPDX-License-Identifier: Apache-2.0
// What is made of the whole grid, as a file writes it: extrusion, revolution, a mirrored copy.
#pragma once

#include "topology/case.h"
#include "topology/read_values.h"

namespace hexweave {

/// Reads `extrude`, `revolve` and `mirror` of a case.
void read_sweep_and_mirror(Reading& reading, const YamlNode& root, Case& c);

}  // namespace hexweave
