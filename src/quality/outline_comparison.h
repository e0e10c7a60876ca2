// SPDX-License-Identifier: Apache-2.0
// What two grids say of themselves besides their points: zones, boundaries, interfaces, units.
#pragma once

#include <string>
#include <vector>

#include "core/grid_outline.h"
#include "core/point_box.h"
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
/// interface is stored. A type that a family declares is told of the family, any other of the
/// boundary. An interface of the candidate whose two ends contradict each other is a difference.
/// `golden_box` has the size of the grids, beside which periodicities are the same or not.
std::vector<Difference> compare_outlines(const GridOutline& candidate, const GridOutline& golden,
                                         const std::vector<ZoneMatch>& matches,
                                         const PointBox& golden_box);

}  // namespace hexweave
