// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace hexweave {

namespace {

/// On the surface, in sizes of it: what was found no farther off is not doubted.
constexpr double on_surface = 1e-12;

double width(const std::array<double, 2>& range) {
    return range[1] - range[0];
}

/// A step of the two parameters, in widths of their ranges.
struct Step {
    double u = 0;
    double v = 0;
};

/// Levenberg's and Marquardt's minimization of the distance within the ranges. It needs no inverse
/// of the metric, so that it converges at degenerate edges as well: linearly, where the derivative
/// vanishes at the solution itself.
class Descent {
public:
    Descent(const Surface& surface, double size, const Vec3& target, const SurfaceParameters& start)
        : surface_(surface), noise_(1e-15 * size), target_(target), at_(start) {
        look();
    }

    SurfacePoint run() {
        constexpr int most_steps = 200;
        for (int n = 0; n < most_steps && damping_ < 1e12; ++n) {
            const double moved = advance();
            if (distance_ == 0 || moved <= noise_) break;
        }
        return {at_, position_, distance_};
    }

private:
    void look() {
        position_ = evaluate(surface_, at_);
        distance_ = distance(position_, target_);
        along_u_ = width(surface_.range_u) * evaluate_derivative_u(surface_, at_);
        along_v_ = width(surface_.range_v) * evaluate_derivative_v(surface_, at_);
    }

    /// The linearized step with the present damping; a parameter that would leave its range stays,
    /// and the other one moves as if there were none but it.
    Step step() const {
        const Vec3 off = target_ - position_;
        const double right_u = dot(along_u_, off);
        const double right_v = dot(along_v_, off);
        const bool stay_u = is_held(at_.u, right_u, surface_.range_u, surface_.closed_u);
        const bool stay_v = is_held(at_.v, right_v, surface_.range_v, surface_.closed_v);
        const Step both = step_of(stay_u ? 0 : right_u, stay_v ? 0 : right_v, stay_u || stay_v);
        if (!stay_u && both.u != 0 && is_held(at_.u, both.u, surface_.range_u, surface_.closed_u)) {
            return step_of(0, stay_v ? 0 : right_v, true);
        }
        if (!stay_v && both.v != 0 && is_held(at_.v, both.v, surface_.range_v, surface_.closed_v)) {
            return step_of(stay_u ? 0 : right_u, 0, true);
        }
        return both;
    }

    Step step_of(double right_u, double right_v, bool apart) const {
        double uu = dot(along_u_, along_u_);
        double vv = dot(along_v_, along_v_);
        const double added = (damping_ + 1e-15) * std::max(uu, vv);
        const double uv = apart ? 0 : dot(along_u_, along_v_);
        uu += added;
        vv += added;
        const double determinant = uu * vv - uv * uv;
        if (!(determinant > 0)) return {};
        return {(vv * right_u - uv * right_v) / determinant,
                (uu * right_v - uv * right_u) / determinant};
    }

    static bool is_held(double at, double downhill, const std::array<double, 2>& range,
                        bool closed) {
        return !closed && ((at <= range[0] && downhill <= 0) || (at >= range[1] && downhill >= 0));
    }

    static double moved_in(double at, double step, const std::array<double, 2>& range,
                           bool closed) {
        const double to = at + step * width(range);
        return closed ? to : std::clamp(to, range[0], range[1]);
    }

    /// Half the rate at which the squared distance falls along the parameters that may move: it
    /// still tells one point from the next where their distances are the same to rounding.
    double slope() const {
        const Vec3 off = target_ - position_;
        const double u = dot(along_u_, off);
        const double v = dot(along_v_, off);
        const bool stay_u = is_held(at_.u, u, surface_.range_u, surface_.closed_u);
        const bool stay_v = is_held(at_.v, v, surface_.range_v, surface_.closed_v);
        return std::hypot(stay_u ? 0 : u, stay_v ? 0 : v);
    }

    /// Whether this is nearer than `before`, or as near to rounding and better placed.
    bool is_better_than(const Descent& before) const {
        if (distance_ < before.distance_ - noise_) return true;
        return distance_ <= before.distance_ + noise_ && slope() < before.slope();
    }

    /// One step; returns how far it moved the point. Uphill steps are not taken, and the next one
    /// is damped more.
    double advance() {
        const Step wanted = step();
        const Descent before = *this;
        at_ = {moved_in(at_.u, wanted.u, surface_.range_u, surface_.closed_u),
               moved_in(at_.v, wanted.v, surface_.range_v, surface_.closed_v)};
        const double moved = norm((at_.u - before.at_.u) / width(surface_.range_u) * along_u_ +
                                  (at_.v - before.at_.v) / width(surface_.range_v) * along_v_);
        look();
        if (is_better_than(before)) {
            damping_ = damping_ > 1e-9 ? 0.1 * damping_ : 0;
            return moved;
        }
        at_ = before.at_;
        position_ = before.position_;
        distance_ = before.distance_;
        along_u_ = before.along_u_;
        along_v_ = before.along_v_;
        damping_ = std::max(10 * damping_, 1e-4);
        return moved;
    }

    const Surface& surface_;
    double noise_;  ///< of distances
    Vec3 target_;
    SurfaceParameters at_;
    Vec3 position_;
    double distance_ = 0;
    Vec3 along_u_;
    Vec3 along_v_;
    double damping_ = 0;
};

/// The value that differs from `parameter` by whole periods and is nearest to `reference`.
double continued_along(double parameter, double reference, const std::array<double, 2>& range,
                       bool closed) {
    if (!closed) return parameter;
    return parameter + std::round((reference - parameter) / width(range)) * width(range);
}

}  // namespace

SurfaceParameters continued(const Surface& surface, const SurfaceParameters& at,
                            const SurfaceParameters& reference) {
    return {continued_along(at.u, reference.u, surface.range_u, surface.closed_u),
            continued_along(at.v, reference.v, surface.range_v, surface.closed_v)};
}

SurfaceProjection::SurfaceProjection(Surface surface) : surface_(std::move(surface)) {
    for (int j = 0; j <= intervals_; ++j) {
        for (int i = 0; i <= intervals_; ++i) {
            samples_.push_back(evaluate(surface_, net_parameters(i, j)));
        }
    }
    Vec3 low = samples_.front();
    Vec3 high = low;
    for (const Vec3& p : samples_) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    size_ = distance(low, high);
    const double room = bulge();
    box_ = {low - Vec3{room, room, room}, high + Vec3{room, room, room}};
}

/// How far the surface leaves its samples: an arc is an eighth of its second difference from its
/// chord, in either direction; twice that.
double SurfaceProjection::bulge() const {
    double greatest = 0;
    const auto at = [&](int i, int j) { return samples_[net_node(i, j)]; };
    for (int n = 0; n <= intervals_; ++n) {
        for (int m = 1; m < intervals_; ++m) {
            greatest = std::max({greatest, norm(at(m - 1, n) - 2 * at(m, n) + at(m + 1, n)),
                                 norm(at(n, m - 1) - 2 * at(n, m) + at(n, m + 1))});
        }
    }
    return greatest / 2;
}

SurfaceParameters SurfaceProjection::net_parameters(int i, int j) const {
    const auto at = [](const std::array<double, 2>& range, int n) {
        return n == intervals_ ? range[1] : range[0] + width(range) * n / intervals_;
    };
    return {at(surface_.range_u, i), at(surface_.range_v, j)};
}

SurfacePoint SurfaceProjection::nearest_from(const Vec3& p, const SurfaceParameters& start) const {
    return Descent(surface_, size_, p, start).run();
}

SurfacePoint SurfaceProjection::nearest(const Vec3& p) const {
    constexpr std::size_t most_starts = 8;
    std::vector<double> distances;
    distances.reserve(samples_.size());
    for (const Vec3& sample : samples_) distances.push_back(distance(sample, p));
    const auto at = [&](int i, int j) { return distances[net_node(i, j)]; };
    std::vector<std::pair<double, std::array<int, 2>>> starts;
    for (int j = 0; j <= intervals_; ++j) {
        for (int i = 0; i <= intervals_; ++i) {
            bool least = true;
            for (int b = std::max(j - 1, 0); b <= std::min(j + 1, intervals_); ++b) {
                for (int a = std::max(i - 1, 0); a <= std::min(i + 1, intervals_); ++a) {
                    least = least && at(i, j) <= at(a, b);
                }
            }
            if (least) starts.emplace_back(at(i, j), std::array{i, j});
        }
    }
    std::stable_sort(starts.begin(), starts.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    if (starts.size() > most_starts) starts.resize(most_starts);
    SurfacePoint best{net_parameters(0, 0), samples_.front(), distances.front()};
    const auto consider = [&](const SurfaceParameters& start) {
        if (best.distance <= on_surface * size_) return;
        const SurfacePoint other = nearest_from(p, start);
        if (other.distance < best.distance) best = other;
    };
    for (const auto& [distance_to, node] : starts) {
        const auto [i, j] = node;
        consider(net_parameters(i, j));
        // A sample at which derivatives vanish leads nowhere; the middles of its cells do.
        for (const int b : {std::max(j - 1, 0), std::min(j, intervals_ - 1)}) {
            for (const int a : {std::max(i - 1, 0), std::min(i, intervals_ - 1)}) {
                const SurfaceParameters low = net_parameters(a, b);
                const SurfaceParameters high = net_parameters(a + 1, b + 1);
                consider({0.5 * (low.u + high.u), 0.5 * (low.v + high.v)});
            }
        }
    }
    const double middle_u = 0.5 * (surface_.range_u[0] + surface_.range_u[1]);
    const double middle_v = 0.5 * (surface_.range_v[0] + surface_.range_v[1]);
    best.parameters = continued(surface_, best.parameters, {middle_u, middle_v});
    return best;
}

SurfaceParameters SurfaceProjection::nearest_sample(const Vec3& p) const {
    constexpr double inside = 0.25 / intervals_;
    std::size_t nearest = 0;
    double least = INFINITY;
    for (std::size_t n = 0; n < samples_.size(); ++n) {
        const Vec3 off = samples_[n] - p;
        const double square = dot(off, off);
        if (square >= least) continue;
        least = square;
        nearest = n;
    }
    constexpr auto columns = static_cast<std::size_t>(intervals_) + 1;
    const SurfaceParameters at =
        net_parameters(static_cast<int>(nearest % columns), static_cast<int>(nearest / columns));
    const auto moved_in = [&](double parameter, const std::array<double, 2>& range) {
        const double margin = inside * width(range);
        return std::clamp(parameter, range[0] + margin, range[1] - margin);
    };
    return {moved_in(at.u, surface_.range_u), moved_in(at.v, surface_.range_v)};
}

std::vector<SurfacePoint> SurfaceProjection::along(const std::vector<Vec3>& line) const {
    std::vector<SurfacePoint> found;
    found.reserve(line.size());
    for (const Vec3& p : line) {
        if (found.empty()) {
            found.push_back(nearest(p));
            continue;
        }
        const SurfaceParameters before = found.back().parameters;
        SurfacePoint next = nearest_from(p, before);
        if (next.distance > on_surface * size_) {
            SurfacePoint other = nearest(p);
            other.parameters = continued(surface_, other.parameters, before);
            if (other.distance < next.distance) next = other;
        }
        found.push_back(next);
    }
    return found;
}

}  // namespace hexweave
