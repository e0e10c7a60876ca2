// SPDX-License-Identifier: Apache-2.0
#include "geometry/lines.h"

#include <algorithm>
#include <cstddef>
#include <memory>

#include "geometry/knots.h"

namespace hexweave {

Curve straight_line(const Vec3& a, const Vec3& b) {
    Curve line;
    line.position = [a, b](double t) { return lerp(a, b, t); };
    line.derivative = [a, b](double) { return b - a; };
    return line;
}

CurveResult polyline(const std::vector<Vec3>& points) {
    if (points.size() < 2) return std::string("a polyline needs at least two points");
    if (const std::string fault = coincident_points(points); !fault.empty()) return fault;

    struct Chain {
        std::vector<Vec3> points;
        std::vector<double> knots;
    };
    const auto chain = std::make_shared<const Chain>(Chain{points, chord_length_knots(points)});
    Curve curve;
    curve.position = [chain](double t) {
        const std::size_t k = knot_interval(chain->knots, t);
        const double width = chain->knots[k + 1] - chain->knots[k];
        return lerp(chain->points[k], chain->points[k + 1], (t - chain->knots[k]) / width);
    };
    curve.derivative = [chain](double t) {
        const std::size_t k = knot_interval(chain->knots, t);
        const double width = chain->knots[k + 1] - chain->knots[k];
        return (chain->points[k + 1] - chain->points[k]) / width;
    };
    curve.begin = chain->knots.front();
    curve.end = chain->knots.back();
    curve.closed = points.front() == points.back();
    curve.breaks.assign(chain->knots.begin() + 1, chain->knots.end() - 1);
    return curve;
}

}  // namespace hexweave
