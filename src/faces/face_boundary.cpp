// SPDX-License-Identifier: Apache-2.0
#include "faces/face_boundary.h"

#include <algorithm>

#include "core/assert.h"

namespace hexweave {

std::vector<Vec3> side_points(const Face& face, Side side, const std::vector<EdgeGrid>& edges) {
    std::vector<Vec3> line;
    for (const EdgeUse& use : face.side(side)) {
        std::vector<Vec3> points = edges[static_cast<std::size_t>(use.edge)].points;
        if (use.reversed) std::reverse(points.begin(), points.end());
        HEXWEAVE_ASSERT(line.empty() || line.back() == points.front());
        if (!line.empty()) line.pop_back();
        line.insert(line.end(), points.begin(), points.end());
    }
    return line;
}

PointField face_boundary(const Face& face, const std::vector<EdgeGrid>& edges) {
    PointField points(face.extent());
    const int ni = points.extent().ni;
    const int nj = points.extent().nj;
    const auto jmin = side_points(face, Side::jmin, edges);
    const auto jmax = side_points(face, Side::jmax, edges);
    const auto imin = side_points(face, Side::imin, edges);
    const auto imax = side_points(face, Side::imax, edges);
    HEXWEAVE_ASSERT(jmin.size() == static_cast<std::size_t>(ni) && jmax.size() == jmin.size());
    HEXWEAVE_ASSERT(imin.size() == static_cast<std::size_t>(nj) && imax.size() == imin.size());
    HEXWEAVE_ASSERT(imin.front() == jmin.front() && imax.front() == jmin.back());
    HEXWEAVE_ASSERT(imin.back() == jmax.front() && imax.back() == jmax.back());
    for (int i = 0; i < ni; ++i) {
        points.set(i, 0, 0, jmin[static_cast<std::size_t>(i)]);
        points.set(i, nj - 1, 0, jmax[static_cast<std::size_t>(i)]);
    }
    for (int j = 0; j < nj; ++j) {
        points.set(0, j, 0, imin[static_cast<std::size_t>(j)]);
        points.set(ni - 1, j, 0, imax[static_cast<std::size_t>(j)]);
    }
    return points;
}

}  // namespace hexweave
