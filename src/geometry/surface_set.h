// SPDX-License-Identifier: Apache-2.0
// Several surfaces that together are one shape, as the patches of a CAD model are: the nearest
// point of any of them.
#pragma once

#include <memory>
#include <vector>

#include "core/vec3.h"
#include "geometry/surface.h"
#include "geometry/surface_projection.h"

namespace hexweave {

/// A place on one of several surfaces.
struct PatchPoint {
    int patch = 0;
    SurfacePoint point;
};

/// Finds nearest points on a set of surfaces. Where several surfaces meet, to 1e-11 of the size,
/// the one searched first has the point: of the places to start from, else of the set. Where two
/// overlap (their feet are 1e-5 of the size apart, and their normals a degree) it is the first of
/// the set.
class SurfaceSet {
public:
    /// Precondition: at least one.
    explicit SurfaceSet(const std::vector<std::shared_ptr<const Surface>>& surfaces);

    const Surface& surface(int patch) const { return at(patch).surface(); }
    const SurfaceProjection& projection(int patch) const { return at(patch); }
    int count() const { return static_cast<int>(patches_.size()); }
    /// The diagonal of the box around all of them.
    double size() const { return size_; }

    /// The nearest point of all surfaces.
    PatchPoint nearest(const Vec3& p) const;

    /// The nearest of the points that are reached downhill from `starts` (at least one), each on
    /// its own surface. From the border of a surface the search goes on to the others that may be
    /// nearer.
    PatchPoint nearest_from(const Vec3& p, const std::vector<PatchPoint>& starts) const;

    /// The places of a line of points, each found from the one before; parameters are continued as
    /// long as the line stays on one surface.
    std::vector<PatchPoint> along(const std::vector<Vec3>& line) const;

    /// The place that the first of overlapping surfaces gives to a point whose nearest one is
    /// `found`. A trimmed surface, taken as the rectangle around what it is trimmed to, overlaps
    /// with its neighbours: it is to be named after them.
    PatchPoint on_first(const Vec3& p, const PatchPoint& found) const;

    /// Whether a place is on the border of its surface, where it does not close.
    bool on_border(const PatchPoint& place) const;

private:
    const SurfaceProjection& at(int patch) const {
        return patches_[static_cast<std::size_t>(patch)];
    }
    /// Whether `other` is nearer than what was found before it.
    bool is_nearer(const PatchPoint& other, const PatchPoint& found) const;
    /// Whether a surface may have a point nearer than `distance_to`.
    bool may_be_nearer(int patch, const Vec3& p, double distance_to) const;

    std::vector<SurfaceProjection> patches_;
    double size_ = 0;
};

}  // namespace hexweave
