// SPDX-License-Identifier: Apache-2.0
// Entries of instances moved from the coordinates of their components to those of the case.
#pragma once

#include "topology/case.h"
#include "topology/read_values.h"

namespace hexweave {

/// Moves, turns and mirrors points and planes, scales every length (sizes of cells, heights, gaps),
/// and runs faces and blocks that are mirrored the other way along i, so that they stay
/// right-handed. Curves and surfaces were moved when they were read. `root` holds the sections that
/// the entries of `c` were read from, one for one.
void place_instances(Reading& reading, const YamlNode& root, Case& c);

}  // namespace hexweave
