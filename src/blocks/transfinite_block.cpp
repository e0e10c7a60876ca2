// SPDX-License-Identifier: Apache-2.0
#include "blocks/transfinite_block.h"

#include <array>

#include "blocks/block_boundary.h"
#include "core/assert.h"
#include "core/parallel.h"

namespace hexweave {

namespace {

/// The trilinear map of the eight corners of a block.
class CornerMap {
public:
    explicit CornerMap(const PointField& points) {
        const Extent e = points.extent();
        for (std::size_t c = 0; c < 8; ++c) {
            corners_[c] =
                points(c & 1U ? e.ni - 1 : 0, c & 2U ? e.nj - 1 : 0, c & 4U ? e.nk - 1 : 0);
        }
    }

    Vec3 operator()(double s, double t, double u) const {
        const Vec3 low =
            lerp(lerp(corners_[0], corners_[1], s), lerp(corners_[2], corners_[3], s), t);
        const Vec3 high =
            lerp(lerp(corners_[4], corners_[5], s), lerp(corners_[6], corners_[7], s), t);
        return lerp(low, high, u);
    }

private:
    std::array<Vec3, 8> corners_;
};

/// How far the points of one side lie from the trilinear map at their parameters; the field's i and
/// j are the side's tangential axes.
PointField deviations(const PointField& points, const ParameterField& parameters,
                      const CornerMap& corner_map, Side side) {
    const Extent extent = points.extent();
    const auto [a_axis, b_axis] = tangential_axes(side);
    PointField result(Extent{extent[a_axis], extent[b_axis], 1});
    for (int b = 0; b < extent[b_axis]; ++b) {
        for (int a = 0; a < extent[a_axis]; ++a) {
            const Node n = side_node(side, a, b, extent);
            const std::size_t node = extent.offset(n[0], n[1], n[2]);
            result.set(a, b, 0,
                       points[node] -
                           corner_map(parameters.s[node], parameters.t[node], parameters.u[node]));
        }
    }
    return result;
}

/// Bilinear interpolation of the deviations of the four edges along one axis.
Vec3 blend(const Vec3& v00, const Vec3& v10, const Vec3& v01, const Vec3& v11, double first,
           double second) {
    return lerp(lerp(v00, v10, first), lerp(v01, v11, first), second);
}

}  // namespace

void interpolate_block(PointField& points, const ParameterField& parameters) {
    const Extent e = points.extent();
    HEXWEAVE_ASSERT(parameters.s.extent() == e && parameters.u.extent() == e);
    const CornerMap corner_map(points);
    std::array<PointField, 6> sides;
    for (const Side side : all_sides) {
        sides[static_cast<std::size_t>(side)] = deviations(points, parameters, corner_map, side);
    }
    const PointField& imin = sides[0];
    const PointField& imax = sides[1];
    const PointField& jmin = sides[2];
    const PointField& jmax = sides[3];
    const PointField& kmin = sides[4];
    const PointField& kmax = sides[5];
    const int last_j = e.nj - 1;
    const int last_k = e.nk - 1;
    const int last_i = e.ni - 1;
    parallel_for(static_cast<std::size_t>(e.nk), [&](std::size_t layer) {
        const int k = static_cast<int>(layer);
        if (k == 0 || k == last_k) return;
        for (int j = 1; j < last_j; ++j) {
            for (int i = 1; i < last_i; ++i) {
                const std::size_t node = e.offset(i, j, k);
                const double s = parameters.s[node];
                const double t = parameters.t[node];
                const double u = parameters.u[node];
                const Vec3 faces = lerp(imin(j, k), imax(j, k), s) +
                                   lerp(jmin(i, k), jmax(i, k), t) +
                                   lerp(kmin(i, j), kmax(i, j), u);
                const Vec3 edges =
                    blend(jmin(i, 0), jmax(i, 0), jmin(i, last_k), jmax(i, last_k), t, u) +
                    blend(imin(j, 0), imax(j, 0), imin(j, last_k), imax(j, last_k), s, u) +
                    blend(imin(0, k), imax(0, k), imin(last_j, k), imax(last_j, k), s, t);
                points.set(node, corner_map(s, t, u) + (faces - edges));
            }
        }
    });
}

}  // namespace hexweave
