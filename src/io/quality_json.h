// SPDX-License-Identifier: Apache-2.0
// The quality of a grid as programs read it (docs/json.md).
#pragma once

#include <string>

#include "quality/grid_quality.h"

namespace hexweave {

/// One object, indented by two spaces, with a newline at its end. Numbers that are not finite are
/// null; node and cell indices count from 1.
std::string to_json(const GridQuality& quality, const std::string& grid_file);

}  // namespace hexweave
