// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_parts.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace hexweave {

namespace {

using Range = std::array<double, 2>;

/// Breaks and seams strictly inside a part of a parameter's range.
std::vector<double> breaks_inside(const Range& part, const Range& range, bool closed,
                                  const std::vector<double>& breaks) {
    Curve line;
    line.begin = range[0];
    line.end = range[1];
    line.closed = closed;
    line.breaks = breaks;
    return joints_between(line, part[0], part[1]);
}

std::vector<double> mirrored(const std::vector<double>& breaks, const Range& range) {
    std::vector<double> result;
    result.reserve(breaks.size());
    std::transform(breaks.rbegin(), breaks.rend(), std::back_inserter(result),
                   [&](double at) { return range[0] + (range[1] - at); });
    return result;
}

}  // namespace

Surface surface_part(const Surface& surface, const Range& range_u, const Range& range_v) {
    Surface part;
    part.position = [surface](double u, double v) { return evaluate(surface, {u, v}); };
    part.derivative_u = [surface](double u, double v) {
        return evaluate_derivative_u(surface, {u, v});
    };
    part.derivative_v = [surface](double u, double v) {
        return evaluate_derivative_v(surface, {u, v});
    };
    part.range_u = range_u;
    part.range_v = range_v;
    const auto whole = [](const Range& a, const Range& b) { return a[1] - a[0] == b[1] - b[0]; };
    part.closed_u = surface.closed_u && whole(range_u, surface.range_u);
    part.closed_v = surface.closed_v && whole(range_v, surface.range_v);
    part.breaks_u = breaks_inside(range_u, surface.range_u, surface.closed_u, surface.breaks_u);
    part.breaks_v = breaks_inside(range_v, surface.range_v, surface.closed_v, surface.breaks_v);
    return part;
}

Surface swapped(const Surface& surface) {
    Surface other = surface;
    other.position = [at = surface.position](double u, double v) { return at(v, u); };
    other.derivative_u = [at = surface.derivative_v](double u, double v) { return at(v, u); };
    other.derivative_v = [at = surface.derivative_u](double u, double v) { return at(v, u); };
    std::swap(other.range_u, other.range_v);
    std::swap(other.closed_u, other.closed_v);
    std::swap(other.breaks_u, other.breaks_v);
    return other;
}

Surface reversed_u(const Surface& surface) {
    Surface other = surface;
    const auto back = [range = surface.range_u](double u) { return range[0] + (range[1] - u); };
    other.position = [surface, back](double u, double v) {
        return evaluate(surface, {back(u), v});
    };
    other.derivative_u = [surface, back](double u, double v) {
        return -evaluate_derivative_u(surface, {back(u), v});
    };
    other.derivative_v = [surface, back](double u, double v) {
        return evaluate_derivative_v(surface, {back(u), v});
    };
    other.breaks_u = mirrored(surface.breaks_u, surface.range_u);
    return other;
}

Surface reversed_v(const Surface& surface) {
    return swapped(reversed_u(swapped(surface)));
}

Surface extrusion(const Curve& curve, const Curve& path) {
    Surface surface;
    surface.position = [at = curve.position, along = path.position,
                        start = path.position(path.begin)](double u, double v) {
        return at(u) + (along(v) - start);
    };
    surface.derivative_u = [along = curve.derivative](double u, double) { return along(u); };
    surface.derivative_v = [along = path.derivative](double, double v) { return along(v); };
    surface.range_u = {curve.begin, curve.end};
    surface.range_v = {path.begin, path.end};
    surface.closed_u = curve.closed;
    surface.closed_v = path.closed;
    surface.breaks_u = curve.breaks;
    surface.breaks_v = path.breaks;
    return surface;
}

}  // namespace hexweave
