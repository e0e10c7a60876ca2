// SPDX-License-Identifier: Apache-2.0
#include "geometry/curve_on_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/lines.h"
#include "geometry/spline.h"
#include "geometry/surface_curves.h"

namespace hexweave {

namespace {

/// A foot of the curve: at its parameter `t`.
struct Foot {
    double t = 0;
    PatchPoint place;
};

/// The ends of the curve and its breaks.
std::vector<double> smooth_ends(const Curve& curve) {
    std::vector<double> ends{curve.begin};
    ends.insert(ends.end(), curve.breaks.begin(), curve.breaks.end());
    ends.push_back(curve.end);
    return ends;
}

class Projection {
public:
    Projection(const Curve& curve, const SurfaceSet& surfaces)
        : curve_(curve), surfaces_(surfaces) {}

    /// On one surface each.
    std::vector<Curve> parts() {
        const std::vector<double> ends = smooth_ends(curve_);
        for (std::size_t n = 0; n + 1 < ends.size(); ++n) walk(ends[n], ends[n + 1]);
        return std::move(parts_);
    }

private:
    Vec3 point_at(double t) const { return curve_.position(t); }

    Foot first_foot(double t) const { return {t, surfaces_.nearest(point_at(t))}; }
    Foot next_foot(double t, const Foot& before) const {
        return {t, surfaces_.nearest_from(point_at(t), {before.place})};
    }

    /// The first foot, to rounding, that is not on the surface of `before` any more, on the way to
    /// `after`, which is on another one.
    Foot crossing(Foot before, Foot after) const {
        constexpr int most_halvings = 60;
        for (int n = 0; n < most_halvings; ++n) {
            const double middle = 0.5 * (before.t + after.t);
            if (!(middle > before.t && middle < after.t)) break;
            const Foot foot = next_foot(middle, before);
            (foot.place.patch == before.place.patch ? before : after) = foot;
        }
        return after;
    }

    /// Follows the curve over a smooth piece from surface to surface.
    void walk(double a, double b) {
        constexpr int steps = 64;
        constexpr int most_crossings = 16;  // in a step
        const double tiny = 1e-12 * (b - a);
        Foot start = first_foot(a);
        Foot at = start;
        for (int n = 1; n <= steps; ++n) {
            const double t = n == steps ? b : a + (b - a) * n / steps;
            Foot next = next_foot(t, at);
            for (int crossings = 0; next.place.patch != at.place.patch; ++crossings) {
                at = crossings < most_crossings ? crossing(at, next) : next;
                if (at.t - start.t > tiny) {
                    add_part(start, at.t);
                    start = at;
                } else {
                    start.place = at.place;
                }
                next = next_foot(t, at);
            }
            at = next;
        }
        if (b - start.t > tiny) add_part(start, b);
    }

    /// The spline through the feet of the curve from `start` on, on its surface; the more feet the
    /// less it is off between them.
    void add_part(const Foot& start, double end) {
        constexpr int fewest = 16;
        constexpr int most = 512;
        constexpr double close = 1e-10;  // sizes of the surfaces
        const SurfaceProjection& projection = surfaces_.projection(start.place.patch);
        const Surface& surface = projection.surface();
        for (int intervals = fewest;; intervals *= 2) {
            std::vector<double> knots;
            std::vector<Vec3> values;
            std::vector<SurfacePoint> feet;
            SurfaceParameters before = start.place.point.parameters;
            for (int n = 0; n <= 2 * intervals; ++n) {
                const double t =
                    n == 2 * intervals ? end : start.t + (end - start.t) * n / (2 * intervals);
                feet.push_back(projection.nearest_from(point_at(t), before));
                before = feet.back().parameters;
                if (n % 2 == 1) continue;
                knots.push_back(t);
                values.push_back({before.u, before.v, 0});
            }
            SplineEnds ends;
            ends.corner = true;
            const Curve spline = spline_at(knots, values, ends);
            double off = 0;
            for (std::size_t n = 1; n < feet.size(); n += 2) {
                const double t = 0.5 * (knots[n / 2] + knots[n / 2 + 1]);
                const Vec3 uv = spline.position(t);
                off = std::max(off, distance(evaluate(surface, {uv.x, uv.y}), feet[n].position));
            }
            if (off > close * surfaces_.size() && intervals < most) continue;
            parts_.push_back(curve_on(surface, spline));
            return;
        }
    }

    const Curve& curve_;
    const SurfaceSet& surfaces_;
    std::vector<Curve> parts_;
};

/// The part that holds a parameter; at a border the one behind.
const Curve& part_at(const std::vector<Curve>& parts, double t) {
    const auto behind =
        std::upper_bound(parts.begin(), parts.end(), t,
                         [](double value, const Curve& part) { return value < part.begin; });
    return behind == parts.begin() ? parts.front() : *(behind - 1);
}

}  // namespace

Curve parameter_line(const Surface& surface, const SurfaceParameters& from,
                     const SurfaceParameters& to) {
    return curve_on(surface, straight_line({from.u, from.v, 0}, {to.u, to.v, 0}));
}

Curve projected_curve(const Curve& curve, const SurfaceSet& surfaces) {
    const auto parts =
        std::make_shared<const std::vector<Curve>>(Projection(curve, surfaces).parts());
    Curve image;
    image.begin = curve.begin;
    image.end = curve.end;
    image.closed = curve.closed;
    for (const Curve& part : *parts) {
        if (part.begin > curve.begin) image.breaks.push_back(part.begin);
        image.breaks.insert(image.breaks.end(), part.breaks.begin(), part.breaks.end());
    }
    image.position = [parts](double t) { return part_at(*parts, t).position(t); };
    image.derivative = [parts](double t) { return part_at(*parts, t).derivative(t); };
    return image;
}

}  // namespace hexweave
