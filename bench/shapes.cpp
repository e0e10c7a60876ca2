// SPDX-License-Identifier: Apache-2.0
#include "bench/shapes.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/stretching.h"

namespace hexweave::bench {

using std::numbers::pi;

double half_thickness(double x) {
    return 0.6 *
           (0.2969 * std::sqrt(x) + x * (-0.1260 + x * (-0.3516 + x * (0.2843 + x * -0.1036))));
}

double chord_fraction(double u) {
    return u == 1 ? 0 : (1 + std::cos(pi * u)) / 2;
}

Vec3 quarter_sphere(double u, double v) {
    const double end = pi / 4 * v;
    const double crest = pi / 2 * v;
    // In the plane of the circle: x, and the height above the line through its ends.
    const double along_y = std::sin(crest) - std::sin(end);
    const double along_z = v == 1 ? 0 : std::cos(crest);
    const double height = std::hypot(along_y, along_z);
    const double half_width = std::cos(end);
    const double centre = (height * height - half_width * half_width) / (2 * height);
    const double radius = height - centre;
    const double first = std::atan2(-centre, half_width);
    const double angle = first + u * (pi - 2 * first);
    const bool at_end = u == 0 || u == 1;
    const double x = at_end ? (u == 0 ? half_width : -half_width) : radius * std::cos(angle);
    const double rise = at_end ? 0 : (centre + radius * std::sin(angle)) / height;
    return {x, std::sin(end) + rise * along_y, rise * along_z};
}

std::vector<Vec3> geometric_line(const Vec3& a, const Vec3& b, int points, double first) {
    std::vector<Vec3> line;
    for (const double f : geometric_fractions(points - 1, first / distance(a, b), std::nullopt)) {
        line.push_back(lerp(a, b, f));
    }
    return line;
}

}  // namespace hexweave::bench
