// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geometry/knots.h"
#include "geometry/spline.h"
#include "geometry/surface_projection.h"

namespace hexweave {

namespace {

/// Where the part x or y of a planar curve, picked by `part`, passes a value between two
/// parameters at which it is on different sides of it.
template <class Part>
double crossing(const Curve& curve, Part part, double value, double low, double high) {
    const bool rises = part(curve.position(low)) < value;
    for (double middle = 0.5 * (low + high); middle > low && middle < high;
         middle = 0.5 * (low + high)) {
        ((part(curve.position(middle)) < value) == rises ? low : high) = middle;
    }
    return high;
}

/// The parameters of a planar curve between which its parts are sampled: several between breaks.
std::vector<double> stations_of(const Curve& curve) {
    constexpr int samples = 16;
    std::vector<double> joints{curve.begin};
    joints.insert(joints.end(), curve.breaks.begin(), curve.breaks.end());
    joints.push_back(curve.end);
    std::vector<double> stations;
    for (std::size_t k = 0; k + 1 < joints.size(); ++k) {
        for (int n = 0; n < samples; ++n) {
            stations.push_back(joints[k] + (joints[k + 1] - joints[k]) * n / samples);
        }
    }
    stations.push_back(curve.end);
    return stations;
}

/// Where a planar curve crosses the breaks, and the seam, of one parameter of a surface.
template <class Part>
void add_crossings(const Curve& curve, Part part, const Curve& parameter,
                   const std::vector<double>& stations, std::vector<double>& found) {
    for (std::size_t n = 0; n + 1 < stations.size(); ++n) {
        const double a = part(curve.position(stations[n]));
        const double b = part(curve.position(stations[n + 1]));
        for (const double at : joints_between(parameter, std::min(a, b), std::max(a, b))) {
            found.push_back(crossing(curve, part, at, stations[n], stations[n + 1]));
        }
        const bool inner = n + 2 < stations.size();
        if (inner &&
            !joints_between(parameter, std::nextafter(b, -INFINITY), std::nextafter(b, INFINITY))
                 .empty()) {
            found.push_back(stations[n + 1]);
        }
    }
}

/// A parameter of a surface as a line: only its range and its breaks.
Curve range_and_breaks(const std::array<double, 2>& range, bool closed,
                       const std::vector<double>& breaks) {
    Curve line;
    line.begin = range[0];
    line.end = range[1];
    line.closed = closed;
    line.breaks = breaks;
    return line;
}

std::vector<double> breaks_of_image(const Surface& surface, const Curve& plane) {
    std::vector<double> found = plane.breaks;
    const std::vector<double> stations = stations_of(plane);
    add_crossings(
        plane, [](const Vec3& p) { return p.x; },
        range_and_breaks(surface.range_u, surface.closed_u, surface.breaks_u), stations, found);
    add_crossings(
        plane, [](const Vec3& p) { return p.y; },
        range_and_breaks(surface.range_v, surface.closed_v, surface.breaks_v), stations, found);
    std::sort(found.begin(), found.end());
    // Two that differ by rounding are one.
    const double same = 1e-13 * (plane.end - plane.begin);
    std::vector<double> breaks;
    for (const double at : found) {
        const bool inside = at - plane.begin > same && plane.end - at > same;
        if (inside && (breaks.empty() || at - breaks.back() > same)) breaks.push_back(at);
    }
    return breaks;
}

bool ends_meet(const Curve& curve) {
    constexpr int samples = 16;
    const Vec3 start = curve.position(curve.begin);
    double reach = 0;
    for (int n = 1; n < samples; ++n) {
        const double t = curve.begin + (curve.end - curve.begin) * n / samples;
        reach = std::max(reach, distance(start, curve.position(t)));
    }
    return distance(start, curve.position(curve.end)) <= 1e-12 * reach;
}

/// How often a line goes round along one parameter.
double whole_turns(double difference, const std::array<double, 2>& range, bool closed) {
    return closed ? std::round(difference / (range[1] - range[0])) : 0;
}

/// The closed spline in the plane of the parameters, or beside it: along a closed parameter the
/// line may come back whole periods later. Nothing where its ends do not belong together.
std::optional<Curve> periodic_spline(const Surface& surface, const std::vector<double>& knots,
                                     std::vector<Vec3> parameters) {
    const double width_u = surface.range_u[1] - surface.range_u[0];
    const double width_v = surface.range_v[1] - surface.range_v[0];
    const Vec3 apart = parameters.back() - parameters.front();
    const Vec3 turn{width_u * whole_turns(apart.x, surface.range_u, surface.closed_u),
                    width_v * whole_turns(apart.y, surface.range_v, surface.closed_v), 0};
    constexpr double same = 1e-9;  // of the range
    const Vec3 gap = apart - turn;
    if (std::abs(gap.x) > same * width_u || std::abs(gap.y) > same * width_v) return std::nullopt;
    const Vec3 ramp = turn / knots.back();
    for (std::size_t n = 0; n < knots.size(); ++n) parameters[n] -= knots[n] * ramp;
    parameters.back() = parameters.front();
    const Curve ring = spline_at(knots, parameters);
    Curve line = ring;
    line.position = [at = ring.position, ramp](double t) { return at(t) + t * ramp; };
    line.derivative = [along = ring.derivative, ramp](double t) { return along(t) + ramp; };
    return line;
}

}  // namespace

Curve curve_on(const Surface& surface, const Curve& in_parameters) {
    Curve curve;
    curve.position = [surface, at = in_parameters.position](double t) {
        const Vec3 p = at(t);
        return evaluate(surface, {p.x, p.y});
    };
    curve.derivative = [surface, at = in_parameters.position,
                        along = in_parameters.derivative](double t) {
        const Vec3 p = at(t);
        const Vec3 rate = along(t);
        return rate.x * evaluate_derivative_u(surface, {p.x, p.y}) +
               rate.y * evaluate_derivative_v(surface, {p.x, p.y});
    };
    curve.begin = in_parameters.begin;
    curve.end = in_parameters.end;
    curve.closed = ends_meet(curve);
    curve.breaks = breaks_of_image(surface, in_parameters);
    return curve;
}

Curve line_of_equal_u(const Surface& surface, double u, double begin, double end) {
    Curve line;
    line.position = [u](double v) { return Vec3{u, v, 0}; };
    line.derivative = [](double) { return Vec3{0, 1, 0}; };
    line.begin = begin;
    line.end = end;
    return curve_on(surface, line);
}

Curve line_of_equal_v(const Surface& surface, double v, double begin, double end) {
    Curve line;
    line.position = [v](double u) { return Vec3{u, v, 0}; };
    line.derivative = [](double) { return Vec3{1, 0, 0}; };
    line.begin = begin;
    line.end = end;
    return curve_on(surface, line);
}

ProjectedCurve curve_through(const Surface& surface, const std::vector<Vec3>& points, bool corner) {
    ProjectedCurve made;
    if (points.size() < 2) {
        made.fault = "a curve needs at least two points";
        return made;
    }
    const SurfaceProjection projection(surface);
    made.size = projection.size();
    std::vector<Vec3> feet;
    std::vector<Vec3> parameters;
    for (const SurfacePoint& foot : projection.along(points)) {
        if (foot.distance > made.distance) {
            made.distance = foot.distance;
            made.farthest = feet.size();
        }
        feet.push_back(foot.position);
        parameters.push_back({foot.parameters.u, foot.parameters.v, 0});
    }
    for (std::size_t n = 1; n < feet.size(); ++n) {
        if (distance(feet[n - 1], feet[n]) > 1e-12 * made.size) continue;
        made.fault = "points " + std::to_string(n) + " and " + std::to_string(n + 1) + " coincide";
        return made;
    }
    const bool smooth = points.front() == points.back() && points.size() > 3 && !corner;
    const std::vector<double> knots = chord_length_knots(feet);
    std::optional<Curve> plane;
    if (smooth) plane = periodic_spline(surface, knots, parameters);
    if (!plane) {
        SplineEnds ends;
        ends.corner = true;
        plane = spline_at(knots, parameters, ends);
    }
    made.curve = curve_on(surface, *plane);
    return made;
}

}  // namespace hexweave
