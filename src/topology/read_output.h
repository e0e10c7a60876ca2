// SPDX-License-Identifier: Apache-2.0
// The section `output`: which files the grid goes to.
#pragma once

#include <vector>

#include "core/grid_output.h"
#include "topology/read_values.h"

namespace hexweave {

/// A FILE (of OpenFOAM a folder) under the key of its format; of Plot3D also a mapping of `file`,
/// `form` and `byte_order`. A null section means none.
std::vector<GridOutput> read_output(Reading& reading, const YamlNode* section);

}  // namespace hexweave
