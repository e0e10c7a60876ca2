// SPDX-License-Identifier: Apache-2.0
#include "faces/transfinite_face.h"

#include <vector>

#include "core/assert.h"

namespace hexweave {

namespace {

/// The bilinear map of the four corners of a face.
struct CornerMap {
    Vec3 p00;
    Vec3 p10;
    Vec3 p01;
    Vec3 p11;

    Vec3 operator()(double s, double t) const {
        return lerp(lerp(p00, p10, s), lerp(p01, p11, s), t);
    }
};

/// How far the points of a face's boundary lie from the bilinear map at their parameters.
std::vector<Vec3> deviations(const PointField& points, const ParameterField& parameters,
                             const CornerMap& corner_map, bool along_i, int at) {
    const int count = along_i ? points.extent().ni : points.extent().nj;
    std::vector<Vec3> result;
    result.reserve(static_cast<std::size_t>(count));
    for (int n = 0; n < count; ++n) {
        const std::size_t node =
            along_i ? points.extent().offset(n, at) : points.extent().offset(at, n);
        result.push_back(points[node] - corner_map(parameters.s[node], parameters.t[node]));
    }
    return result;
}

}  // namespace

void interpolate_face(PointField& points, const ParameterField& parameters) {
    const Extent extent = points.extent();
    HEXWEAVE_ASSERT(extent.nk == 1 && parameters.s.extent() == extent);
    const int ni = extent.ni;
    const int nj = extent.nj;
    const CornerMap corner_map{points(0, 0), points(ni - 1, 0), points(0, nj - 1),
                               points(ni - 1, nj - 1)};
    const auto jmin = deviations(points, parameters, corner_map, true, 0);
    const auto jmax = deviations(points, parameters, corner_map, true, nj - 1);
    const auto imin = deviations(points, parameters, corner_map, false, 0);
    const auto imax = deviations(points, parameters, corner_map, false, ni - 1);
    for (int j = 1; j < nj - 1; ++j) {
        const auto row = static_cast<std::size_t>(j);
        for (int i = 1; i < ni - 1; ++i) {
            const auto column = static_cast<std::size_t>(i);
            const double s = parameters.s(i, j);
            const double t = parameters.t(i, j);
            points.set(i, j, 0,
                       corner_map(s, t) +
                           (lerp(imin[row], imax[row], s) + lerp(jmin[column], jmax[column], t)));
        }
    }
}

}  // namespace hexweave
