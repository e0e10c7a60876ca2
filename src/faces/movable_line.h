// SPDX-License-Identifier: Apache-2.0
// The grid lines that leave a wall at which heights are held, and how far each moves.
#pragma once

#include <cstddef>
#include <vector>

#include "core/field.h"
#include "core/vec3.h"
#include "faces/wall_frame.h"
#include "topology/case.h"

namespace hexweave {

/// What keeps a line from the height asked.
enum class Stop { none, growth, fade, folds };

/// A line off the wall as the solve left it, as far as it may move and two points on.
struct MovableLine {
    int a = 0;
    int b = 0;
    std::vector<Vec3> points;
    std::vector<double> distances;
    std::size_t first = 1;  ///< the point that is at the held height
    double fade = 0;
    std::vector<double> log_factors;  ///< at every point
    double part = 1;                  ///< of log_factors that is applied; 0: it cannot move
    Stop stop = Stop::none;
};

/// The line that leaves node (a, b) of the wall; its factors are one all along, as much of what
/// brings its first cell to the height `target` as `request.growth` allows.
MovableLine movable_line(const PointField& points, const WallFrame& wall, int a, int b,
                         double target, double asked_fade, const HeldHeights& request);

/// From the factors at the wall those farther out: smoothed along the wall, the more the farther
/// (see FactorLayer). `lines` are all that leave the wall within its ends.
void spread_outwards(const PointField& points, const WallFrame& wall,
                     std::vector<MovableLine>& lines);

/// Cuts `part` to what the growth of the line allows (see feasible_part).
void limit_growth(MovableLine& line, double growth);

/// Puts the points of a line where `part` of its factors has them; those from the fade distance on
/// stay.
void move_line(PointField& points, const WallFrame& wall, const MovableLine& line);

}  // namespace hexweave
