// SPDX-License-Identifier: Apache-2.0
#include "faces/hermite_map.h"

#include <cmath>
#include <limits>

#include "core/assert.h"

namespace hexweave {

double LineEnds::far_share(double f) const {
    if (upright_at_start && upright_at_end) return (3 - 2 * f) * (f * f);
    if (upright_at_start) return f * f;
    if (upright_at_end) return (2 - f) * f;
    return f;
}

double LineEnds::slope(double f) const {
    if (upright_at_start && upright_at_end) return 6 * (1 - f) * f;
    if (upright_at_start) return 2 * f;
    if (upright_at_end) return 2 * (1 - f);
    return 1;
}

SquarePoint curved_line_point(double s_jmin, double s_jmax, const LineEnds& lines_of_i,
                              double t_imin, double t_imax, const LineEnds& lines_of_j) {
    constexpr int most_steps = 100;
    constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();
    const auto t_at = [&](double s) { return between(t_imin, t_imax, lines_of_j.far_share(s)); };
    double low = 0;
    double high = 1;
    double s = straight_line_point(s_jmin, s_jmax, t_imin, t_imax).s;
    for (int step = 0; step < most_steps; ++step) {
        const double t = t_at(s);
        const double excess = s - between(s_jmin, s_jmax, lines_of_i.far_share(t));
        if (excess == 0) break;
        (excess < 0 ? low : high) = s;
        const double slope =
            1 - (s_jmax - s_jmin) * lines_of_i.slope(t) * (t_imax - t_imin) * lines_of_j.slope(s);
        double next = s - excess / slope;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const bool done = std::abs(next - s) <= rounding * next;
        s = next;
        if (done) break;
    }
    return {s, t_at(s)};
}

ParameterField hermite_map(const EdgeFunctions& edges, const std::array<bool, 4>& orthogonal) {
    const auto& [t_imin, t_imax, s_jmin, s_jmax] = edges;
    HEXWEAVE_ASSERT(t_imin.size() == t_imax.size() && s_jmin.size() == s_jmax.size());
    const Extent extent{static_cast<int>(s_jmin.size()), static_cast<int>(t_imin.size()), 1};
    const LineEnds lines_of_i{orthogonal[2], orthogonal[3]};
    const LineEnds lines_of_j{orthogonal[0], orthogonal[1]};
    ParameterField parameters{Field(extent), Field(extent), {}};
    for (int j = 0; j < extent.nj; ++j) {
        const auto row = static_cast<std::size_t>(j);
        for (int i = 0; i < extent.ni; ++i) {
            const auto column = static_cast<std::size_t>(i);
            const SquarePoint point = curved_line_point(s_jmin[column], s_jmax[column], lines_of_i,
                                                        t_imin[row], t_imax[row], lines_of_j);
            parameters.s(i, j) = point.s;
            parameters.t(i, j) = point.t;
        }
    }
    return parameters;
}

}  // namespace hexweave
