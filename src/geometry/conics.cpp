// SPDX-License-Identifier: Apache-2.0
#include "geometry/conics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/turn.h"
#include "geometry/transform.h"

namespace hexweave {

std::optional<PlaneAxes> plane_axes(const Vec3& normal, const std::optional<Vec3>& x_axis) {
    constexpr double parallel = 1e-12;
    if (!(norm(normal) > 0)) return std::nullopt;
    const Vec3 n = normal / norm(normal);
    const auto across = [&](const Vec3& direction) { return direction - dot(direction, n) * n; };
    const Vec3 global_x{1, 0, 0};
    const Vec3 global_y{0, 1, 0};
    Vec3 wanted = norm(across(global_x)) > parallel ? global_x : global_y;
    if (x_axis) wanted = *x_axis;
    const Vec3 x = across(wanted);
    if (!(norm(x) > parallel * norm(wanted))) return std::nullopt;
    const Vec3 unit_x = x / norm(x);
    return PlaneAxes{unit_x, cross(n, unit_x)};
}

Curve circle(const Vec3& center, double radius, const PlaneAxes& axes) {
    return ellipse(center, radius, radius, 0, axes);
}

Curve ellipse(const Vec3& center, double a, double b, double rotation, const PlaneAxes& axes) {
    const Turn turn = turn_by_quarters(rotation / (std::numbers::pi / 2));
    const Vec3 first = a * (turn.cosine * axes.x + turn.sine * axes.y);
    const Vec3 second = b * (turn.cosine * axes.y - turn.sine * axes.x);
    Curve curve;
    curve.position = [=](double t) {
        const Turn at = turn_by_quarters(t);
        return center + at.cosine * first + at.sine * second;
    };
    curve.derivative = [=](double t) {
        const Turn at = turn_by_quarters(t);
        return (std::numbers::pi / 2) * (at.cosine * second - at.sine * first);
    };
    curve.begin = 0;
    curve.end = 4;
    curve.closed = true;
    return curve;
}

Curve arc(const Vec3& center, double radius, double from, double to, const PlaneAxes& axes) {
    if (to < from) return reversed(arc(center, radius, to, from, axes));
    Curve curve;
    curve.position = [=](double t) {
        return center + radius * (std::cos(t) * axes.x + std::sin(t) * axes.y);
    };
    curve.derivative = [=](double t) {
        return radius * (std::cos(t) * axes.y - std::sin(t) * axes.x);
    };
    curve.begin = from;
    curve.end = to;
    return curve;
}

CurveResult arc_through(const Vec3& start, const Vec3& middle, const Vec3& end) {
    const Vec3 u = middle - start;
    const Vec3 v = end - start;
    const double least = 1e-12;
    const double extent = std::max({norm(u), norm(v), distance(middle, end)});
    if (norm(u) <= least * extent) return std::string("the first two points of the arc coincide");
    if (norm(v) <= least * extent) return std::string("the two ends of the arc coincide");
    if (distance(middle, end) <= least * extent) {
        return std::string("the last two points of the arc coincide");
    }
    const Vec3 normal = cross(u, v);
    if (norm(normal) <= 1e-10 * norm(u) * norm(v)) {
        return std::string("the three points of the arc lie on a straight line");
    }
    // The circumcentre of a triangle with one corner at the origin.
    const Vec3 to_center = cross(dot(u, u) * v - dot(v, v) * u, normal) / (2 * dot(normal, normal));
    const PlaneAxes axes = plane_axes(normal, -to_center).value_or(PlaneAxes{});
    const Vec3 center = start + to_center;
    const Vec3 last = end - center;
    double angle = std::atan2(dot(last, axes.y), dot(last, axes.x));
    if (angle <= 0) angle += 2 * std::numbers::pi;
    return arc(center, norm(to_center), 0, angle, axes);
}

}  // namespace hexweave
