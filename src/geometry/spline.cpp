// SPDX-License-Identifier: Apache-2.0
#include "geometry/spline.h"

#include <cstddef>
#include <memory>
#include <string>

#include "geometry/knots.h"

namespace hexweave {

namespace {

/// A tridiagonal system for the slopes at the knots: one row per knot.
struct SlopeRow {
    double below = 0;
    double diagonal = 1;
    double above = 0;
    Vec3 right;
};

struct SplineData {
    std::vector<double> knots;
    std::vector<Vec3> points;
    std::vector<Vec3> slopes;

    double width(std::size_t k) const { return knots[k + 1] - knots[k]; }
    Vec3 secant(std::size_t k) const { return (points[k + 1] - points[k]) / width(k); }
};

/// Continuity of the second derivative at the knot between intervals k - 1 and k.
SlopeRow inner_row(const SplineData& data, std::size_t before, std::size_t after) {
    const double h0 = data.width(before);
    const double h1 = data.width(after);
    return {h1, 2 * (h0 + h1), h0, 3 * (h1 * data.secant(before) + h0 * data.secant(after))};
}

/// The row of an end knot, seen from that end: `width` and `secant` of the end interval, `width1`
/// and `secant1` of its neighbour; `above` couples to the next knot inwards. Not-a-knot as in
/// [de Boor 1978, A Practical Guide to Splines, chapter IV].
SlopeRow end_row(SplineEnd kind, double width, double width1, const Vec3& secant,
                 const Vec3& secant1) {
    if (kind == SplineEnd::natural) return {0, 2, 1, 3 * secant};
    const double both = width + width1;
    const Vec3 right = ((width + 2 * both) * width1 * secant + (width * width) * secant1) / both;
    return {0, width1, both, right};
}

/// The rows of the two ends; the rule for what the ends do not fix is in SplineEnds.
void set_end_rows(const SplineData& data, const SplineEnds& ends, std::vector<SlopeRow>& rows) {
    const std::size_t last = data.points.size() - 1;
    SplineEnd start = ends.start;
    SplineEnd end = ends.end;
    std::optional<Vec3> start_tangent = ends.start_tangent;
    if (last == 1) start = end = SplineEnd::natural;  // no inner knot: a line without tangents
    const std::size_t next = last == 1 ? 0 : 1;
    const double w0 = data.width(0);
    const double w1 = data.width(next);
    const bool one_parabola = last == 2 && start == SplineEnd::not_a_knot &&
                              end == SplineEnd::not_a_knot && !start_tangent && !ends.end_tangent;
    if (one_parabola) {
        start_tangent = data.secant(0) - (w0 / (w0 + w1)) * (data.secant(1) - data.secant(0));
    }
    rows.front() = start_tangent ? SlopeRow{0, 1, 0, *start_tangent}
                                 : end_row(start, w0, w1, data.secant(0), data.secant(next));
    const std::size_t z = last - 1;
    const std::size_t y = last == 1 ? 0 : last - 2;
    rows.back() = ends.end_tangent
                      ? SlopeRow{0, 1, 0, *ends.end_tangent}
                      : end_row(end, data.width(z), data.width(y), data.secant(z), data.secant(y));
    std::swap(rows.back().below, rows.back().above);
}

/// Gaussian elimination without pivoting: the rows of a spline need none.
std::vector<Vec3> solve_tridiagonal(std::vector<SlopeRow> rows) {
    for (std::size_t k = 1; k < rows.size(); ++k) {
        const double factor = rows[k].below / rows[k - 1].diagonal;
        rows[k].diagonal -= factor * rows[k - 1].above;
        rows[k].right -= factor * rows[k - 1].right;
    }
    std::vector<Vec3> slopes(rows.size());
    for (std::size_t k = rows.size(); k-- > 0;) {
        Vec3 right = rows[k].right;
        if (k + 1 < rows.size()) right -= rows[k].above * slopes[k + 1];
        slopes[k] = right / rows[k].diagonal;
    }
    return slopes;
}

/// The slopes of an open spline.
std::vector<Vec3> open_slopes(const SplineData& data, const SplineEnds& ends) {
    std::vector<SlopeRow> rows(data.points.size());
    for (std::size_t k = 1; k + 1 < rows.size(); ++k) rows[k] = inner_row(data, k - 1, k);
    set_end_rows(data, ends, rows);
    return solve_tridiagonal(std::move(rows));
}

/// The slopes of a periodic spline: a cyclic system by the formula of Sherman and Morrison.
std::vector<Vec3> periodic_slopes(const SplineData& data) {
    const std::size_t n = data.points.size() - 1;
    std::vector<SlopeRow> rows(n);
    for (std::size_t k = 0; k < n; ++k) rows[k] = inner_row(data, k == 0 ? n - 1 : k - 1, k);
    const double corner_above = rows.front().below;  // first row, last unknown
    const double corner_below = rows.back().above;   // last row, first unknown
    const double gamma = -rows.front().diagonal;
    rows.front().diagonal -= gamma;
    rows.back().diagonal -= corner_below * corner_above / gamma;
    const std::vector<Vec3> plain = solve_tridiagonal(rows);
    for (SlopeRow& row : rows) row.right = {};
    rows.front().right = {gamma, 0, 0};
    rows.back().right = {corner_below, 0, 0};
    const std::vector<Vec3> correction = solve_tridiagonal(rows);
    const double v = corner_above / gamma;
    const double denominator = 1 + correction.front().x + v * correction.back().x;
    const Vec3 share = (plain.front() + v * plain.back()) / denominator;
    std::vector<Vec3> slopes(n + 1);
    for (std::size_t k = 0; k < n; ++k) slopes[k] = plain[k] - correction[k].x * share;
    slopes[n] = slopes[0];
    return slopes;
}

/// Cubic Hermite interpolation in interval k at u, 0 <= u <= 1; exactly the points at its ends.
Vec3 hermite(const SplineData& data, std::size_t k, double u) {
    const double h = data.width(k);
    const double v = 1 - u;
    return (v * v * (1 + 2 * u)) * data.points[k] + (u * u * (3 - 2 * u)) * data.points[k + 1] +
           (h * u * v) * (v * data.slopes[k] - u * data.slopes[k + 1]);
}

Vec3 hermite_derivative(const SplineData& data, std::size_t k, double u) {
    const double v = 1 - u;
    return (6 * u * v) * data.secant(k) + (v * (1 - 3 * u)) * data.slopes[k] +
           (u * (3 * u - 2)) * data.slopes[k + 1];
}

bool is_periodic(const std::vector<Vec3>& points, const SplineEnds& ends) {
    return points.front() == points.back() && !ends.corner && !ends.start_tangent &&
           !ends.end_tangent;
}

}  // namespace

Curve spline_at(const std::vector<double>& parameters, const std::vector<Vec3>& points,
                const SplineEnds& ends) {
    SplineData made{parameters, points, {}};
    made.slopes = is_periodic(points, ends) ? periodic_slopes(made) : open_slopes(made, ends);
    const auto data = std::make_shared<const SplineData>(std::move(made));
    Curve curve;
    curve.position = [data](double t) {
        const std::size_t k = knot_interval(data->knots, t);
        return hermite(*data, k, (t - data->knots[k]) / data->width(k));
    };
    curve.derivative = [data](double t) {
        const std::size_t k = knot_interval(data->knots, t);
        return hermite_derivative(*data, k, (t - data->knots[k]) / data->width(k));
    };
    curve.begin = parameters.front();
    curve.end = parameters.back();
    curve.closed = points.front() == points.back();
    curve.breaks.assign(parameters.begin() + 1, parameters.end() - 1);
    return curve;
}

CurveResult spline(const std::vector<Vec3>& points, const SplineEnds& ends) {
    if (points.size() < 2) return std::string("a spline needs at least two points");
    if (const std::string fault = coincident_points(points); !fault.empty()) return fault;
    if (is_periodic(points, ends) && points.size() < 4) {
        return std::string("a closed spline needs at least three different points");
    }
    SplineEnds unit = ends;
    for (std::optional<Vec3>* tangent : {&unit.start_tangent, &unit.end_tangent}) {
        if (!*tangent) continue;
        const double size = norm(**tangent);
        if (!(size > 0)) return std::string("a tangent of the spline has no length");
        **tangent = **tangent / size;
    }
    return spline_at(chord_length_knots(points), points, unit);
}

}  // namespace hexweave
