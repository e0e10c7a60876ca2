// SPDX-License-Identifier: Apache-2.0
// What two grids say of themselves besides their points: zones, boundaries, interfaces, units.
#pragma once

#include <string>
#include <vector>

#include "core/grid_outline.h"
#include "quality/zone_match.h"

namespace hexweave {

/// What is not the same: of which kind ("units", "dimensions", "zone", "family", "boundary",
/// "interface"), and a sentence that says it. Nodes are counted from 1.
struct Difference {
    std::string kind;
    std::string text;
};

/// Everything that differs, in the order of the kinds above; nodes are the candidate's. Names of
/// boundary conditions and interfaces do not count, nor does their order, nor the side on which an
/// interface is stored.
std::vector<Difference> compare_outlines(const GridOutline& candidate, const GridOutline& golden,
                                         const std::vector<ZoneMatch>& matches);

}  // namespace hexweave
