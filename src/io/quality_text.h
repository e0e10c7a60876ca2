// SPDX-License-Identifier: Apache-2.0
// The quality of a grid as people read it.
#pragma once

#include <string>

#include "quality/grid_quality.h"

namespace hexweave {

/// Tables: zones, boundaries, interfaces, histograms, the worst cells; then the verdict's line.
std::string to_text(const GridQuality& quality);

}  // namespace hexweave
