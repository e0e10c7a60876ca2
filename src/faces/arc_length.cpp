// SPDX-License-Identifier: Apache-2.0
#include "faces/arc_length.h"

#include <algorithm>

#include "core/assert.h"

namespace hexweave {

std::vector<Vec3> grid_line(const PointField& points, std::array<int, 3> start, int axis) {
    const int count = points.extent()[axis];
    std::vector<Vec3> line;
    line.reserve(static_cast<std::size_t>(count));
    std::array<int, 3> node = start;
    for (int n = 0; n < count; ++n) {
        node[static_cast<std::size_t>(axis)] = n;
        line.push_back(points(node[0], node[1], node[2]));
    }
    return line;
}

bool has_length(const std::vector<Vec3>& line) {
    return std::any_of(line.begin(), line.end(), [&](const Vec3& p) { return p != line.front(); });
}

std::vector<double> normalized_arc_length(const std::vector<Vec3>& line) {
    HEXWEAVE_ASSERT(line.size() > 1);
    std::vector<double> fractions(line.size(), 0.0);
    for (std::size_t n = 1; n < line.size(); ++n) {
        fractions[n] = fractions[n - 1] + distance(line[n - 1], line[n]);
    }
    const double length = fractions.back();
    HEXWEAVE_ASSERT(length > 0);
    for (double& fraction : fractions) fraction /= length;
    return fractions;
}

}  // namespace hexweave
