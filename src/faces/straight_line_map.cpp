// SPDX-License-Identifier: Apache-2.0
#include "faces/straight_line_map.h"

#include <cmath>

#include "core/assert.h"
#include "faces/arc_length.h"

namespace hexweave {

namespace {

/// 1 - |b - a| for a and b of [0, 1], accurate relative to itself where it is small.
double one_minus_difference(double a, double b) {
    return a < b ? a + (1 - b) : b + (1 - a);
}

}  // namespace

double between(double a, double b, double f) {
    return f < 0.5 ? a + f * (b - a) : b - (1 - f) * (b - a);
}

SquarePoint straight_line_point(double s_jmin, double s_jmax, double t_imin, double t_imax) {
    const double product = (s_jmax - s_jmin) * (t_imax - t_imin);
    // 1 - product, also where both lines run nearly from corner to corner.
    double determinant = 1 - product;
    if (product > 0.5) {
        const double e = one_minus_difference(s_jmin, s_jmax);
        const double f = one_minus_difference(t_imin, t_imax);
        determinant = (e + f) - e * f;
    }
    return {between(s_jmin, s_jmax, t_imin) / determinant,
            between(t_imin, t_imax, s_jmin) / determinant};
}

ParameterField straight_line_map(const PointField& boundary,
                                 const std::array<EndExponents, 4>& exponents) {
    const Extent extent = boundary.extent();
    HEXWEAVE_ASSERT(extent.nk == 1);
    const auto s = parallel_edge_functions(
        {grid_line(boundary, {0, 0, 0}, 0), grid_line(boundary, {0, extent.nj - 1, 0}, 0)},
        {exponents[2], exponents[3]});
    const auto t = parallel_edge_functions(
        {grid_line(boundary, {0, 0, 0}, 1), grid_line(boundary, {extent.ni - 1, 0, 0}, 1)},
        {exponents[0], exponents[1]});
    ParameterField parameters{Field(extent), Field(extent), {}};
    for (int j = 0; j < extent.nj; ++j) {
        const auto row = static_cast<std::size_t>(j);
        for (int i = 0; i < extent.ni; ++i) {
            const auto column = static_cast<std::size_t>(i);
            const SquarePoint point =
                straight_line_point(s[0][column], s[1][column], t[0][row], t[1][row]);
            parameters.s(i, j) = point.s;
            parameters.t(i, j) = point.t;
        }
    }
    return parameters;
}

}  // namespace hexweave
