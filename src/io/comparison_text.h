// SPDX-License-Identifier: Apache-2.0
// A comparison of two grids as people read it.
#pragma once

#include <string>

#include "quality/grid_comparison.h"

namespace hexweave {

/// A table of the zones, then a line for everything else that differs, then the nodes that were not
/// compared.
std::string to_text(const GridComparison& comparison);

/// One line, without its end: "same: ..." or "different: ...".
std::string verdict(const GridComparison& comparison);

}  // namespace hexweave
