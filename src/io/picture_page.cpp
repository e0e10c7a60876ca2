// SPDX-License-Identifier: Apache-2.0
#include "io/picture_page.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/errors.h"

namespace hexweave {

namespace {

double distance_to_segment(const PagePoint& p, const PagePoint& a, const PagePoint& b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double along = square > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0;
    const double f = std::clamp(along, 0.0, 1.0);
    return std::hypot(p.x - a.x - f * dx, p.y - a.y - f * dy);
}

Polyline merged(const Polyline& line, double distance) {
    Polyline result{line.front()};
    for (const PagePoint& point : line) {
        if (std::hypot(point.x - result.back().x, point.y - result.back().y) >= distance) {
            result.push_back(point);
        }
    }
    if (result.back() == line.back()) return result;
    if (result.size() > 1) result.pop_back();
    result.push_back(line.back());
    return result;
}

/// One side of a frame as a half plane: how far inside it a point is.
double inside(const Frame& frame, int side, const PagePoint& p) {
    switch (side) {
        case 0:
            return p.x - frame.left;
        case 1:
            return frame.right - p.x;
        case 2:
            return p.y - frame.top;
        default:
            return frame.bottom - p.y;
    }
}

}  // namespace

Camera look_from(const Vec3& eye, const std::optional<Vec3>& up) {
    Camera camera;
    camera.eye = eye / norm(eye);
    const bool along_z = std::abs(camera.eye.z) > 0.999;
    const Vec3 upwards = up ? *up / norm(*up) : along_z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 right = cross(upwards, camera.eye);
    if (!(norm(right) > 1e-6)) throw UsageError("the view and what points up are parallel");
    camera.right = right / norm(right);
    camera.up = cross(camera.eye, camera.right);
    return camera;
}

bool is_finite(const Sight& sight) {
    return std::isfinite(sight.x) && std::isfinite(sight.y) && std::isfinite(sight.depth);
}

Vec3 View::plane_coordinates(const Vec3& point) const {
    return {dot(point, camera.right), dot(point, camera.up), dot(point, camera.eye)};
}

Sight View::place(const Vec3& point) const {
    const Vec3 d = scale * (plane_coordinates(point) - centre);
    return {(frame.left + frame.right) / 2 + d.x, (frame.top + frame.bottom) / 2 - d.y, d.z};
}

std::array<double, 4> View::window() const {
    const double half_width = frame.width() / 2 / scale;
    const double half_height = frame.height() / 2 / scale;
    return {centre.x - half_width, centre.y - half_height, centre.x + half_width,
            centre.y + half_height};
}

std::optional<std::array<Sight, 2>> clip(const Frame& frame, const Sight& a, const Sight& b) {
    if (!is_finite(a) || !is_finite(b)) return std::nullopt;
    double begin = 0;
    double end = 1;
    for (int side = 0; side < 4; ++side) {
        const double at_a = inside(frame, side, {a.x, a.y});
        const double at_b = inside(frame, side, {b.x, b.y});
        if (at_a < 0 && at_b < 0) return std::nullopt;
        if (at_a < 0) begin = std::max(begin, at_a / (at_a - at_b));
        if (at_b < 0) end = std::min(end, at_a / (at_a - at_b));
    }
    if (begin > end) return std::nullopt;
    const auto point = [&](double f) {
        return Sight{a.x + f * (b.x - a.x), a.y + f * (b.y - a.y),
                     a.depth + f * (b.depth - a.depth)};
    };
    return std::array{begin == 0 ? a : point(begin), end == 1 ? b : point(end)};
}

Polyline clip_polygon(const Frame& frame, const Polyline& ring) {
    Polyline result = ring;
    for (int side = 0; side < 4 && !result.empty(); ++side) {
        const Polyline whole = std::exchange(result, {});
        PagePoint last = whole.back();
        for (const PagePoint& next : whole) {
            const double at_last = inside(frame, side, last);
            const double at_next = inside(frame, side, next);
            if ((at_last < 0) != (at_next < 0)) {
                const double f = at_last / (at_last - at_next);
                result.push_back({last.x + f * (next.x - last.x), last.y + f * (next.y - last.y)});
            }
            if (at_next >= 0) result.push_back(next);
            last = next;
        }
    }
    return result;
}

Polyline simplified(const Polyline& line, double tolerance) {
    if (line.size() < 3) return line;
    const Polyline dense = merged(line, 0.3);
    std::vector<char> kept(dense.size(), 0);
    kept.front() = kept.back() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, dense.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        double worst = tolerance;
        std::size_t middle = 0;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double off = distance_to_segment(dense[i], dense[first], dense[last]);
            if (off > worst) {
                worst = off;
                middle = i;
            }
        }
        if (middle == 0) continue;
        kept[middle] = 1;
        open.emplace_back(first, middle);
        open.emplace_back(middle, last);
    }
    Polyline result;
    for (std::size_t i = 0; i < dense.size(); ++i) {
        if (kept[i] != 0) result.push_back(dense[i]);
    }
    return result;
}

}  // namespace hexweave
