// SPDX-License-Identifier: Apache-2.0
#include "geometry/transform.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/turn.h"

namespace hexweave {

namespace {

constexpr Affine identity{};

Vec3 column(const Affine& map, std::size_t j) {
    const auto part = [&](const Vec3& row) { return j == 0 ? row.x : j == 1 ? row.y : row.z; };
    return {part(map.rows[0]), part(map.rows[1]), part(map.rows[2])};
}

/// The linear map of `rows`, leaving `center` in its place.
Affine about(const std::array<Vec3, 3>& rows, const Vec3& center) {
    Affine map{rows, {}};
    map.offset = center - apply_to_direction(map, center);
    return map;
}

}  // namespace

Vec3 apply_to_direction(const Affine& map, const Vec3& direction) {
    return {dot(map.rows[0], direction), dot(map.rows[1], direction), dot(map.rows[2], direction)};
}

Vec3 apply(const Affine& map, const Vec3& point) {
    return apply_to_direction(map, point) + map.offset;
}

Affine compose(const Affine& first, const Affine& second) {
    Affine both;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& row = second.rows[i];
        both.rows[i] = {dot(row, column(first, 0)), dot(row, column(first, 1)),
                        dot(row, column(first, 2))};
    }
    both.offset = apply(second, first.offset);
    return both;
}

bool is_identity(const Affine& map) {
    return map.rows == identity.rows && map.offset == identity.offset;
}

Affine translation(const Vec3& by) {
    return {identity.rows, by};
}

Affine scaling(const Vec3& factors, const Vec3& center) {
    return about({Vec3{factors.x, 0, 0}, Vec3{0, factors.y, 0}, Vec3{0, 0, factors.z}}, center);
}

Affine rotation(const Vec3& axis, double angle, const Vec3& center) {
    // Rodrigues' formula, applied to the unit vectors.
    const Vec3 n = axis / norm(axis);
    const Turn turn = turn_by(angle);
    const auto turned = [&](const Vec3& v) {
        return turn.cosine * v + turn.sine * cross(n, v) + ((1 - turn.cosine) * dot(n, v)) * n;
    };
    const Vec3 x = turned({1, 0, 0});
    const Vec3 y = turned({0, 1, 0});
    const Vec3 z = turned({0, 0, 1});
    return about({Vec3{x.x, y.x, z.x}, Vec3{x.y, y.y, z.y}, Vec3{x.z, y.z, z.z}}, center);
}

Affine reflection(const Vec3& point, const Vec3& normal) {
    const Vec3 n = normal / norm(normal);
    const auto row = [&](double part, const Vec3& unit) { return unit - (2 * part) * n; };
    return about({row(n.x, {1, 0, 0}), row(n.y, {0, 1, 0}), row(n.z, {0, 0, 1})}, point);
}

Curve transformed(const Curve& curve, const Affine& map) {
    Curve image = curve;
    image.position = [position = curve.position, map](double t) { return apply(map, position(t)); };
    image.derivative = [derivative = curve.derivative, map](double t) {
        return apply_to_direction(map, derivative(t));
    };
    return image;
}

Curve reversed(const Curve& curve) {
    Curve back;
    back.position = [position = curve.position](double t) { return position(-t); };
    back.derivative = [derivative = curve.derivative](double t) { return -derivative(-t); };
    back.begin = -curve.end;
    back.end = -curve.begin;
    back.closed = curve.closed;
    back.breaks.resize(curve.breaks.size());
    std::transform(curve.breaks.rbegin(), curve.breaks.rend(), back.breaks.begin(),
                   [](double at) { return -at; });
    return back;
}

Curve piece(const Curve& curve, double a, double b) {
    if (b < a) return reversed(piece(curve, b, a));
    Curve part;
    part.position = [curve](double t) { return evaluate(curve, t); };
    part.derivative = [curve](double t) { return evaluate_derivative(curve, t); };
    part.begin = a;
    part.end = b;
    part.closed = curve.closed && b - a == curve.period();
    part.breaks = joints_between(curve, a, b);
    return part;
}

Curve piece_by_fractions(const Curve& curve, double from, double to) {
    const ArcLengthTable table(curve, curve.begin, curve.end);
    const auto parameter = [&](double fraction) {
        const bool inside = fraction >= 0 && fraction <= 1;
        const double turns = inside || !curve.closed ? 0 : std::floor(fraction);
        return table.parameter_at((fraction - turns) * table.length()) + turns * curve.period();
    };
    return piece(curve, parameter(from), parameter(to));
}

}  // namespace hexweave
