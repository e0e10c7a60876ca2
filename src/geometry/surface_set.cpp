// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hexweave {

namespace {

/// On the surface, in sizes of the set: what was found no farther off is not doubted.
constexpr double on_surface = 1e-12;
/// Feet that are no farther apart than this, in sizes of the set, are one place.
constexpr double same_place = 1e-11;
/// Of distances, in sizes of the set.
constexpr double rounding = 1e-14;
/// Surfaces overlap where their feet are no farther apart than this, in sizes of the set, and their
/// normals no more than this cosine tells.
constexpr double overlap = 1e-5;
constexpr double same_normal = 0.9998;

Vec3 normal_at(const Surface& surface, const SurfaceParameters& at) {
    const Vec3 normal =
        cross(evaluate_derivative_u(surface, at), evaluate_derivative_v(surface, at));
    const double length = norm(normal);
    return length > 0 ? normal / length : Vec3{};
}

}  // namespace

SurfaceSet::SurfaceSet(const std::vector<std::shared_ptr<const Surface>>& surfaces) {
    patches_.reserve(surfaces.size());
    for (const auto& surface : surfaces) patches_.emplace_back(*surface);
    SampleBox all = patches_.front().box();
    for (const SurfaceProjection& patch : patches_) {
        const SampleBox& box = patch.box();
        all.low = {std::min(all.low.x, box.low.x), std::min(all.low.y, box.low.y),
                   std::min(all.low.z, box.low.z)};
        all.high = {std::max(all.high.x, box.high.x), std::max(all.high.y, box.high.y),
                    std::max(all.high.z, box.high.z)};
    }
    size_ = distance(all.low, all.high);
}

bool SurfaceSet::is_nearer(const PatchPoint& other, const PatchPoint& found) const {
    if (distance(other.point.position, found.point.position) <= same_place * size_) return false;
    if (other.point.distance < found.point.distance) return true;
    // Just beyond a border the distance does not tell yet, but one of the two is no true foot.
    return on_border(found) && !on_border(other) &&
           other.point.distance <= found.point.distance + rounding * size_;
}

bool SurfaceSet::may_be_nearer(int patch, const Vec3& p, double distance_to) const {
    const SampleBox& box = at(patch).box();
    const auto beyond = [](double x, double low, double high) {
        return std::max({low - x, x - high, 0.0});
    };
    const Vec3 off{beyond(p.x, box.low.x, box.high.x), beyond(p.y, box.low.y, box.high.y),
                   beyond(p.z, box.low.z, box.high.z)};
    return norm(off) < distance_to;
}

PatchPoint SurfaceSet::nearest(const Vec3& p) const {
    PatchPoint best{0, at(0).nearest(p)};
    for (int patch = 1; patch < count(); ++patch) {
        if (best.point.distance <= on_surface * size_) break;
        if (!may_be_nearer(patch, p, best.point.distance)) continue;
        const PatchPoint other{patch, at(patch).nearest(p)};
        if (is_nearer(other, best)) best = other;
    }
    return on_first(p, best);
}

PatchPoint SurfaceSet::on_first(const Vec3& p, const PatchPoint& found) const {
    if (found.patch == 0 || on_border(found)) return found;
    for (int patch = 0; patch < found.patch; ++patch) {
        if (!may_be_nearer(patch, p, found.point.distance + overlap * size_)) continue;
        const PatchPoint other{patch, at(patch).nearest_from(p, at(patch).nearest_sample(p))};
        if (on_border(other)) continue;
        if (distance(other.point.position, found.point.position) > overlap * size_) continue;
        const double cosine = dot(normal_at(surface(patch), other.point.parameters),
                                  normal_at(surface(found.patch), found.point.parameters));
        if (std::abs(cosine) >= same_normal) return other;
    }
    return found;
}

bool SurfaceSet::on_border(const PatchPoint& place) const {
    const Surface& s = surface(place.patch);
    const auto at_end = [](double parameter, const std::array<double, 2>& range, bool closed) {
        return !closed && (parameter <= range[0] || parameter >= range[1]);
    };
    return at_end(place.point.parameters.u, s.range_u, s.closed_u) ||
           at_end(place.point.parameters.v, s.range_v, s.closed_v);
}

PatchPoint SurfaceSet::nearest_from(const Vec3& p, const std::vector<PatchPoint>& starts) const {
    const auto from = [&](const PatchPoint& start) {
        return PatchPoint{start.patch, at(start.patch).nearest_from(p, start.point.parameters)};
    };
    PatchPoint best = from(starts.front());
    std::vector<bool> searched(patches_.size(), false);
    searched[static_cast<std::size_t>(best.patch)] = true;
    for (std::size_t n = 1; n < starts.size(); ++n) {
        const PatchPoint other = from(starts[n]);
        searched[static_cast<std::size_t>(other.patch)] = true;
        if (is_nearer(other, best)) best = other;
    }
    if (best.point.distance <= on_surface * size_ || !on_border(best)) return on_first(p, best);
    for (int patch = 0; patch < count(); ++patch) {
        if (searched[static_cast<std::size_t>(patch)]) continue;
        if (!may_be_nearer(patch, p, best.point.distance)) continue;
        const PatchPoint other{patch, at(patch).nearest_from(p, at(patch).nearest_sample(p))};
        if (is_nearer(other, best)) best = other;
    }
    return on_first(p, best);
}

std::vector<PatchPoint> SurfaceSet::along(const std::vector<Vec3>& line) const {
    std::vector<PatchPoint> found;
    found.reserve(line.size());
    for (const Vec3& p : line) {
        if (found.empty()) {
            found.push_back(nearest(p));
            continue;
        }
        const PatchPoint before = found.back();
        PatchPoint next = nearest_from(p, {before});
        if (next.point.distance > on_surface * size_) {
            PatchPoint other = nearest(p);
            if (is_nearer(other, next)) {
                if (other.patch == before.patch) {
                    other.point.parameters = continued(surface(other.patch), other.point.parameters,
                                                       before.point.parameters);
                }
                next = other;
            }
        }
        found.push_back(next);
    }
    return found;
}

}  // namespace hexweave
