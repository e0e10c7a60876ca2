// SPDX-License-Identifier: Apache-2.0
#include "faces/wall_heights.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"

namespace hexweave {

namespace {

/// d point / d distance at point n: of the parabola through it and its neighbours.
Vec3 slope_at(const std::vector<Vec3>& points, const std::vector<double>& distances,
              std::size_t n) {
    const std::size_t last = points.size() - 1;
    if (last == 1) return (points[1] - points[0]) / (distances[1] - distances[0]);
    const std::size_t middle = std::clamp<std::size_t>(n, 1, last - 1);
    const double before = distances[middle] - distances[middle - 1];
    const double after = distances[middle + 1] - distances[middle];
    const Vec3 first = (points[middle] - points[middle - 1]) / before;
    const Vec3 second = (points[middle + 1] - points[middle]) / after;
    const Vec3 bend = (second - first) / (before + after);
    if (n < middle) return first - before * bend;
    if (n > middle) return second + after * bend;
    return first + before * bend;
}

}  // namespace

std::vector<double> distances_along(const std::vector<Vec3>& line) {
    std::vector<double> distances(line.size(), 0.0);
    for (std::size_t n = 1; n < line.size(); ++n) {
        distances[n] = distances[n - 1] + distance(line[n - 1], line[n]);
    }
    return distances;
}

std::vector<Vec3> points_at(const std::vector<Vec3>& points, const std::vector<double>& distances,
                            const std::vector<double>& wanted) {
    HEXWEAVE_ASSERT(points.size() == distances.size() && points.size() > 1);
    std::vector<Vec3> result;
    result.reserve(wanted.size());
    std::size_t n = 0;
    for (const double r : wanted) {
        while (n + 2 < points.size() && distances[n + 1] < r) ++n;
        const double cell = distances[n + 1] - distances[n];
        const double f = (r - distances[n]) / cell;
        const Vec3 chord = points[n + 1] - points[n];
        const Vec3 at_start = cell * slope_at(points, distances, n) - chord;
        const Vec3 at_end = cell * slope_at(points, distances, n + 1) - chord;
        // The chord, and what a cubic of these slopes adds to it: nothing on a straight line.
        result.push_back(points[n] + f * chord + f * (1 - f) * ((1 - f) * at_start - f * at_end));
    }
    return result;
}

double feasible_part(const std::vector<double>& distances, const std::vector<double>& log_factors,
                     double fade, double growth, std::size_t first) {
    constexpr double margin = 1.25;  // on the growth of a line that is beyond the bound already
    const double allowed = std::max(growth, 1 + margin * (greatest_growth(distances) - 1));
    const auto allows = [&](double part) {
        std::vector<double> parts = log_factors;
        for (double& log_factor : parts) log_factor *= part;
        return greatest_growth(scaled_distances(distances, parts, fade, first)) <= allowed;
    };
    const bool finite = std::all_of(log_factors.begin(), log_factors.end(),
                                    [](double log_factor) { return std::isfinite(log_factor); });
    if (!finite || distances.size() <= first || distances[first] >= fade) return 0;
    if (allows(1)) return 1;
    constexpr int halvings = 30;
    double low = 0;
    double high = 1;
    for (int n = 0; n < halvings; ++n) {
        const double middle = 0.5 * (low + high);
        (allows(middle) ? low : high) = middle;
    }
    return low;
}

double fade_on_line(double asked_fade, double line_length) {
    return std::min(asked_fade, 0.5 * line_length);
}

}  // namespace hexweave
