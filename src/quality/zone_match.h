// SPDX-License-Identifier: Apache-2.0
// Which zone of one grid is which of another.
#pragma once

#include <vector>

#include "core/grid_outline.h"
#include "quality/point_source.h"

namespace hexweave {

/// Zone `candidate` of the one grid is zone `golden` of the other; `to_golden` takes the axes of
/// the first to those of the second.
struct ZoneMatch {
    int candidate = 0;
    int golden = 0;
    Orientation to_golden;
};

/// Zones of the same name, in the order of the candidate's zones.
std::vector<ZoneMatch> match_by_name(const GridOutline& candidate, const GridOutline& golden);

/// Zones of the same shape, whatever they are called, in whatever order they stand and whichever
/// way their axes run: of the same numbers of nodes up to their order, each sample nearer to its
/// counterpart than a tenth of the zone's diagonal. Nearest pairs first; of equals, those of the
/// same name and then those whose axes run alike.
std::vector<ZoneMatch> match_by_shape(const GridOutline& candidate,
                                      const std::vector<ZoneSurvey>& candidate_surveys,
                                      const GridOutline& golden,
                                      const std::vector<ZoneSurvey>& golden_surveys);

/// All ways in which the axes of one index space run along those of another: 48 in three
/// dimensions, 8 in two. The first is the identity.
const std::vector<Orientation>& all_orientations(int cell_dimension);

}  // namespace hexweave
