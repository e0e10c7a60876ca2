// SPDX-License-Identifier: Apache-2.0
// The `surfaces:` of a file: families and transforms.
#pragma once

#include <vector>

#include "topology/case.h"
#include "topology/read_values.h"

namespace hexweave {

/// One entry for every key, in order; without a shape where it is faulty. Marks the curves that
/// surfaces are made of.
std::vector<SurfaceEntry> read_surfaces(Reading& reading, const YamlNode& section,
                                        std::vector<CurveEntry>& curves);

}  // namespace hexweave
