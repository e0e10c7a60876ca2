// SPDX-License-Identifier: Apache-2.0
#include "geometry/knots.h"

#include <algorithm>

namespace hexweave {

std::vector<double> chord_length_knots(const std::vector<Vec3>& points) {
    std::vector<double> knots(points.size(), 0.0);
    for (std::size_t k = 1; k < points.size(); ++k) {
        knots[k] = knots[k - 1] + distance(points[k - 1], points[k]);
    }
    return knots;
}

std::size_t knot_interval(const std::vector<double>& knots, double t) {
    const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, t);
    return static_cast<std::size_t>(above - knots.begin()) - 1;
}

std::string coincident_points(const std::vector<Vec3>& points) {
    const double least = 1e-14 * chord_length_knots(points).back();
    for (std::size_t k = 1; k < points.size(); ++k) {
        if (distance(points[k - 1], points[k]) <= least) {
            return "points " + std::to_string(k) + " and " + std::to_string(k + 1) + " coincide";
        }
    }
    return {};
}

}  // namespace hexweave
