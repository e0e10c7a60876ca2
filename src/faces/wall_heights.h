// SPDX-License-Identifier: Apache-2.0
// A grid line that leaves a wall, its first cell brought to an asked height: its points move along
// the line, by the asked over the present height at the wall and fading to nothing farther out.
#pragma once

#include <cstddef>
#include <vector>

#include "core/vec3.h"
#include "geometry/wall_scaling.h"

namespace hexweave {

/// The distance of each point from the first, along the polygon of the points.
std::vector<double> distances_along(const std::vector<Vec3>& line);

/// The points of a curve through `points` (at least two, all different) at other distances, which
/// ascend and lie in the range of `distances` = distances_along(points). Between two points the
/// curve is a cubic with the slopes of parabolas through three neighbours: third order of accuracy,
/// exact on straight lines.
std::vector<Vec3> points_at(const std::vector<Vec3>& points, const std::vector<double>& distances,
                            const std::vector<double>& wanted);

/// The part, 0 to 1, of `log_factors` that can be had such that scaled_distances ascend and do not
/// grow faster than `growth` - or, where they grow nearly as fast already, by a quarter more.
/// `first` as for scaled_distances.
double feasible_part(const std::vector<double>& distances, const std::vector<double>& log_factors,
                     double fade, double growth, std::size_t first = 1);

/// How far a face or block may be moved in one line: half of it at most, so that lines between two
/// walls obey both.
double fade_on_line(double asked_fade, double line_length);

}  // namespace hexweave
