// SPDX-License-Identifier: Apache-2.0
// The `curves:` of a file: families, transforms, and the data files that they name.
#pragma once

#include <vector>

#include "topology/case.h"
#include "topology/read_values.h"

namespace hexweave {

/// One entry for every key, in order; without a shape where it is faulty.
std::vector<CurveEntry> read_curves(Reading& reading, const YamlNode& section);

}  // namespace hexweave
