// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "geometry/conics.h"
#include "geometry/differences.h"

namespace hexweave {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

double into_range(double parameter, const std::array<double, 2>& range, bool closed) {
    if (parameter >= range[0] && parameter <= range[1]) return parameter;
    if (!closed) return std::clamp(parameter, range[0], range[1]);
    const double period = range[1] - range[0];
    return std::clamp(parameter - std::floor((parameter - range[0]) / period) * period, range[0],
                      range[1]);
}

SurfaceParameters into_range(const Surface& surface, const SurfaceParameters& at) {
    return {into_range(at.u, surface.range_u, surface.closed_u),
            into_range(at.v, surface.range_v, surface.closed_v)};
}

double share(const std::array<double, 2>& range, int part, int parts) {
    return range[0] + (range[1] - range[0]) * part / parts;
}

/// A curve over shares of its parameter, 0 to 1.
Curve over_shares(const Curve& curve) {
    Curve unit;
    const double begin = curve.begin;
    const double end = curve.end;
    unit.position = [position = curve.position, begin, end](double f) {
        return position(f == 1 ? end : begin + f * (end - begin));
    };
    unit.derivative = [derivative = curve.derivative, begin, end](double f) {
        return (end - begin) * derivative(f == 1 ? end : begin + f * (end - begin));
    };
    unit.closed = curve.closed;
    for (const double at : curve.breaks) unit.breaks.push_back((at - begin) / (end - begin));
    return unit;
}

}  // namespace

void find_closed(Surface& surface) {
    constexpr int samples = 16;
    const auto at = [&](int i, int j) {
        return surface.position(share(surface.range_u, i, samples),
                                share(surface.range_v, j, samples));
    };
    std::array<double, 2> gap{};
    std::array<double, 2> reach{};
    for (int n = 0; n <= samples; ++n) {
        gap[0] = std::max(gap[0], distance(at(0, n), at(samples, n)));
        gap[1] = std::max(gap[1], distance(at(n, 0), at(n, samples)));
        for (int m = 1; m < samples; ++m) {
            reach[0] = std::max(reach[0], distance(at(0, n), at(m, n)));
            reach[1] = std::max(reach[1], distance(at(n, 0), at(n, m)));
        }
    }
    surface.closed_u = gap[0] <= 1e-12 * reach[0];
    surface.closed_v = gap[1] <= 1e-12 * reach[1];
}

Vec3 evaluate(const Surface& surface, const SurfaceParameters& at) {
    const SurfaceParameters inside = into_range(surface, at);
    return surface.position(inside.u, inside.v);
}

Vec3 evaluate_derivative_u(const Surface& surface, const SurfaceParameters& at) {
    const SurfaceParameters inside = into_range(surface, at);
    return surface.derivative_u(inside.u, inside.v);
}

Vec3 evaluate_derivative_v(const Surface& surface, const SurfaceParameters& at) {
    const SurfaceParameters inside = into_range(surface, at);
    return surface.derivative_v(inside.u, inside.v);
}

Surface formula_surface(std::function<Vec3(double, double)> position,
                        const std::array<double, 2>& range_u,
                        const std::array<double, 2>& range_v) {
    Surface surface;
    surface.range_u = range_u;
    surface.range_v = range_v;
    surface.derivative_u = [position, along = Differences(range_u[0], range_u[1])](double u,
                                                                                   double v) {
        return along([&](double t) { return position(t, v); }, u);
    };
    surface.derivative_v = [position, along = Differences(range_v[0], range_v[1])](double u,
                                                                                   double v) {
        return along([&](double t) { return position(u, t); }, v);
    };
    surface.position = std::move(position);
    find_closed(surface);
    return surface;
}

Surface plane_surface(const Vec3& point, const Vec3& along_u, const Vec3& along_v) {
    Surface surface;
    surface.position = [=](double u, double v) { return point + u * along_u + v * along_v; };
    surface.derivative_u = [along_u](double, double) { return along_u; };
    surface.derivative_v = [along_v](double, double) { return along_v; };
    return surface;
}

Surface sphere(const Vec3& center, double radius, const Vec3& axis) {
    Surface surface;
    const PlaneAxes equator = plane_axes(axis).value_or(PlaneAxes{});
    const Vec3 north = cross(equator.x, equator.y);
    const auto outwards = [equator](double u) {
        return std::cos(u) * equator.x + std::sin(u) * equator.y;
    };
    surface.position = [=](double u, double v) {
        return center + radius * (std::cos(v) * outwards(u) + std::sin(v) * north);
    };
    surface.derivative_u = [=](double u, double v) {
        return radius * std::cos(v) * (std::cos(u) * equator.y - std::sin(u) * equator.x);
    };
    surface.derivative_v = [=](double u, double v) {
        return radius * (std::cos(v) * north - std::sin(v) * outwards(u));
    };
    surface.range_u = {0, full_turn};
    surface.range_v = {-full_turn / 4, full_turn / 4};
    surface.closed_u = true;
    return surface;
}

Surface cone(const Vec3& from, const Vec3& to, double radius_from, double radius_to) {
    Surface surface;
    const PlaneAxes plane = plane_axes(to - from).value_or(PlaneAxes{});
    const auto outwards = [plane](double u) {
        return std::cos(u) * plane.x + std::sin(u) * plane.y;
    };
    const auto radius = [=](double v) { return (1 - v) * radius_from + v * radius_to; };
    surface.position = [=](double u, double v) {
        return lerp(from, to, v) + radius(v) * outwards(u);
    };
    surface.derivative_u = [=](double u, double v) {
        return radius(v) * (std::cos(u) * plane.y - std::sin(u) * plane.x);
    };
    surface.derivative_v = [=](double u, double) {
        return (to - from) + (radius_to - radius_from) * outwards(u);
    };
    surface.range_u = {0, full_turn};
    surface.closed_u = true;
    return surface;
}

Surface ruled_surface(const Curve& first, const Curve& second) {
    Surface surface;
    const Curve a = over_shares(first);
    const Curve b = over_shares(second);
    surface.position = [a, b](double u, double v) { return lerp(a.position(u), b.position(u), v); };
    surface.derivative_u = [a, b](double u, double v) {
        return lerp(a.derivative(u), b.derivative(u), v);
    };
    surface.derivative_v = [a, b](double u, double) { return b.position(u) - a.position(u); };
    surface.closed_u = first.closed && second.closed;
    std::set_union(a.breaks.begin(), a.breaks.end(), b.breaks.begin(), b.breaks.end(),
                   std::back_inserter(surface.breaks_u));
    return surface;
}

Surface revolution(const Curve& curve, const Vec3& center, const Vec3& axis, double turn) {
    Surface surface;
    const Vec3 unit = axis / norm(axis);
    surface.position = [=, position = curve.position](double u, double v) {
        return apply(rotation(unit, u, center), position(v));
    };
    surface.derivative_u = [=, position = curve.position](double u, double v) {
        return cross(unit, apply(rotation(unit, u, center), position(v)) - center);
    };
    surface.derivative_v = [=, derivative = curve.derivative](double u, double v) {
        return apply_to_direction(rotation(unit, u), derivative(v));
    };
    surface.closed_u = turn >= full_turn;
    surface.range_u = {0, std::min(turn, full_turn)};
    surface.range_v = {curve.begin, curve.end};
    surface.closed_v = curve.closed;
    surface.breaks_v = curve.breaks;
    return surface;
}

Surface transformed(const Surface& surface, const Affine& map) {
    Surface image = surface;
    image.position = [position = surface.position, map](double u, double v) {
        return apply(map, position(u, v));
    };
    image.derivative_u = [derivative = surface.derivative_u, map](double u, double v) {
        return apply_to_direction(map, derivative(u, v));
    };
    image.derivative_v = [derivative = surface.derivative_v, map](double u, double v) {
        return apply_to_direction(map, derivative(u, v));
    };
    return image;
}

}  // namespace hexweave
