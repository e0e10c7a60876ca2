// SPDX-License-Identifier: Apache-2.0
#include "faces/flat_corners.h"

#include <cmath>
#include <numbers>

#include "core/orientation.h"

namespace hexweave {

std::array<bool, 4> flat_corners(const PointField& boundary, bool planar) {
    const Extent n = boundary.extent();
    std::array<bool, 4> flat{};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const bool i_max = corner == 1 || corner == 2;
        const bool j_max = corner >= 2;
        const int i = i_max ? n.ni - 1 : 0;
        const int j = j_max ? n.nj - 1 : 0;
        const Vec3 along_i = boundary(i_max ? i - 1 : 1, j) - boundary(i, j);
        const Vec3 along_j = boundary(i, j_max ? j - 1 : 1) - boundary(i, j);
        const Vec3 normal = cross(along_i, along_j);
        double sine = norm(normal);
        if (planar) sine = i_max == j_max ? normal.z : -normal.z;
        double angle = std::atan2(sine, dot(along_i, along_j));
        if (angle < 0) angle += 2 * std::numbers::pi;
        flat[corner] = angle > flat_angle && angle < slit_angle;
    }
    return flat;
}

std::array<EndExponents, 4> corner_exponents(const std::array<bool, 4>& flat, double exponent) {
    std::array<EndExponents, 4> sides;
    auto& [imin, imax, jmin, jmax] = sides;
    const std::array<std::array<double*, 2>, 4> ends{{{&imin.start, &jmin.start},
                                                      {&imax.start, &jmin.end},
                                                      {&imax.end, &jmax.end},
                                                      {&imin.end, &jmax.start}}};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        if (!flat[corner]) continue;
        for (double* end : ends[corner]) *end = exponent;
    }
    return sides;
}

}  // namespace hexweave
