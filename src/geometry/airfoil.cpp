// SPDX-License-Identifier: Apache-2.0
#include "geometry/airfoil.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "geometry/root.h"
#include "geometry/spline.h"
#include "geometry/transform.h"

namespace hexweave {

namespace {

Vec3 trailing_edge(const std::vector<Vec3>& points) {
    return lerp(points.front(), points.back(), 0.5);
}

/// The index of the point farthest from the trailing edge, neither the first nor the last.
std::size_t farthest_point(const std::vector<Vec3>& points) {
    const Vec3 edge = trailing_edge(points);
    std::size_t farthest = 1;
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
        if (distance(points[k], edge) > distance(points[farthest], edge)) farthest = k;
    }
    return farthest;
}

/// The parameter of the leading edge on the spline through the points: of the farthest given point,
/// or, where the spline bulges beyond it, of the spline's own farthest point.
double leading_edge(const Curve& whole, const std::vector<Vec3>& points) {
    constexpr double bulge = 1e-5;
    const Vec3 edge = trailing_edge(points);
    const std::size_t farthest = farthest_point(points);
    // The spline's parameters at its points are its ends and its breaks.
    const auto knot = [&](std::size_t k) {
        return k == 0 ? whole.begin : k + 1 == points.size() ? whole.end : whole.breaks[k - 1];
    };
    const auto recession = [&](double t) {
        return dot(whole.position(t) - edge, whole.derivative(t));
    };
    const double low = knot(farthest - 1);
    const double high = knot(farthest + 1);
    const double given = distance(points[farthest], edge);
    if (recession(low) > 0 && recession(high) < 0) {
        const double extreme = bracketed_root(recession, low, high);
        if (distance(whole.position(extreme), edge) > (1 + bulge) * given) return extreme;
    }
    return knot(farthest);
}

/// Shears both sides so that they end in the middle of the base; the leading edge stays.
std::vector<Vec3> with_closed_trailing_edge(std::vector<Vec3> points) {
    const Vec3 edge = trailing_edge(points);
    const std::size_t nose = farthest_point(points);
    const Vec3 leading = points[nose];
    const Vec3 chord = edge - leading;
    const Vec3 upper_shift = edge - points.front();
    const Vec3 lower_shift = edge - points.back();
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double along =
            std::clamp(dot(points[k] - leading, chord) / dot(chord, chord), 0.0, 1.0);
        points[k] += along * (k <= nose ? upper_shift : lower_shift);
    }
    points.front() = edge;
    points.back() = edge;
    return points;
}

}  // namespace

CurveResult airfoil(const std::vector<Vec3>& points, const AirfoilShape& shape) {
    constexpr std::size_t fewest_points = 5;
    if (points.size() < fewest_points) {
        return "an airfoil needs at least 5 points, not " + std::to_string(points.size());
    }
    const std::vector<Vec3> shaped =
        shape.close_trailing_edge ? with_closed_trailing_edge(points) : points;
    SplineEnds ends;
    ends.corner = true;
    CurveResult through = spline(shaped, ends);
    if (!through.curve) return through;
    Curve whole = *through.curve;
    const double nose = leading_edge(whole, shaped);
    if (shape.chord) {
        const Vec3 leading = whole.position(nose);
        const double extent = trailing_edge(shaped).x - leading.x;
        if (!(extent > 0)) {
            return std::string("the trailing edge does not lie behind the leading edge along x");
        }
        const double factor = *shape.chord / extent;
        whole = transformed(whole, compose(translation(-leading), scaling({factor, factor, 1})));
    }
    switch (shape.side) {
        case AirfoilSide::upper:
            return piece(whole, nose, whole.begin);
        case AirfoilSide::lower:
            return piece(whole, nose, whole.end);
        case AirfoilSide::whole:
            break;
    }
    return whole;
}

CurveResult airfoil_from_text(std::string_view text, AirfoilContent content,
                              const AirfoilShape& shape) {
    const AirfoilPoints read = read_airfoil(text, content);
    if (!read.error.empty()) return {read.error, read.line};
    return airfoil(read.points, shape);
}

}  // namespace hexweave
