// SPDX-License-Identifier: Apache-2.0
// Grid lines on the page: thinned where they crowd, cut off at the frame, without what is hidden.
#pragma once

#include <array>
#include <vector>

#include "io/picture_drawing.h"
#include "io/picture_page.h"
#include "io/picture_surface.h"

namespace hexweave {

/// What lines are drawn through. `raster` may be null: then nothing is hidden.
struct Sieve {
    Frame frame;
    const Raster* raster = nullptr;
};

/// How often line `line` of `lines` is left out: lines of a level l remain where lines 2^l apart
/// have room. The first and last line belong to the boundary and have no level.
int thinning_level(int line, int lines);

/// Grid lines by tone: full, and two thinner ones in which lines fade out where they crowd.
using TonedLines = std::array<std::vector<Polyline>, 3>;

/// The interior grid lines of a sheet, in both directions, each where it is at least `spacing`
/// pixels from the lines of its own and higher levels.
TonedLines grid_lines(const SightSheet& sheet, const Sieve& sieve, double spacing);

/// One line through points, cut off and without its hidden parts.
void append_line(const std::vector<Sight>& points, const Sieve& sieve,
                 std::vector<Polyline>& lines);

}  // namespace hexweave
