// SPDX-License-Identifier: Apache-2.0
#include "faces/movable_line.h"

#include <algorithm>
#include <cmath>

#include "faces/factor_layer.h"
#include "faces/wall_heights.h"

namespace hexweave {

MovableLine movable_line(const PointField& points, const WallFrame& wall, int a, int b,
                         double target, double asked_fade, const HeldHeights& request) {
    MovableLine line{a, b, {}, {}, static_cast<std::size_t>(request.first), 0, {}, 1, Stop::none};
    line.points.reserve(static_cast<std::size_t>(wall.depth()));
    for (int n = 0; n < wall.depth(); ++n) line.points.push_back(points[wall.offset(a, b, n)]);
    line.distances = distances_along(line.points);
    line.fade = fade_on_line(asked_fade, line.distances.back());
    const auto beyond = std::lower_bound(line.distances.begin(), line.distances.end(), line.fade);
    const auto kept = std::min<std::size_t>(
        line.points.size(), static_cast<std::size_t>(beyond - line.distances.begin()) + 2);
    const double log_factor = std::log(target / line.distances[line.first]);
    line.points.resize(kept);
    line.points.shrink_to_fit();
    line.distances.resize(kept);
    line.log_factors.assign(kept, log_factor);
    limit_growth(line, request.growth);
    line.log_factors.assign(kept, line.part == 0 ? 0.0 : line.part * log_factor);
    if (line.part > 0) line.part = 1;
    return line;
}

void limit_growth(MovableLine& line, double growth) {
    if (line.part == 0) return;
    const bool finite = std::isfinite(line.log_factors.front());  // not at a pole
    line.part = feasible_part(line.distances, line.log_factors, line.fade, growth, line.first);
    if (line.part == 1 || line.stop != Stop::none || !finite) return;
    line.stop = line.distances[line.first] >= line.fade ? Stop::fade : Stop::growth;
}

void spread_outwards(const PointField& points, const WallFrame& wall,
                     std::vector<MovableLine>& lines) {
    FactorLayer layer(wall);
    std::size_t depth = 0;
    for (const MovableLine& line : lines) {
        layer.log_factors(line.a, line.b) = line.log_factors.front();
        depth = std::max(depth, line.distances.size());
    }
    for (std::size_t n = 2; n < depth; ++n) {
        for (const MovableLine& line : lines) {
            if (n <= line.first || n >= line.distances.size()) {
                layer.widening(line.a, line.b) = 0;
                continue;
            }
            const double cell = line.distances[n] - line.distances[n - 1];
            layer.widening(line.a, line.b) = cell * (line.distances[n] + line.distances[n - 1]);
        }
        smooth_along_wall(layer, points, wall, static_cast<int>(n));
        for (MovableLine& line : lines) {
            if (n < line.distances.size()) line.log_factors[n] = layer.log_factors(line.a, line.b);
        }
    }
}

void move_line(PointField& points, const WallFrame& wall, const MovableLine& line) {
    std::vector<double> log_factors = line.log_factors;
    for (double& log_factor : log_factors) log_factor *= line.part;
    std::vector<double> wanted =
        scaled_distances(line.distances, log_factors, line.fade, line.first);
    const auto beyond = std::lower_bound(line.distances.begin(), line.distances.end(), line.fade);
    const auto moved = static_cast<std::size_t>(beyond - line.distances.begin());
    wanted.resize(moved);
    const std::vector<Vec3> at =
        line.part == 0 ? line.points : points_at(line.points, line.distances, wanted);
    for (std::size_t n = 1; n < moved; ++n) {
        points.set(wall.offset(line.a, line.b, static_cast<int>(n)), at[n]);
    }
}

}  // namespace hexweave
