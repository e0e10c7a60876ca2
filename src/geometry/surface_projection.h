// SPDX-License-Identifier: Apache-2.0
// The parameters of points on a surface: the nearest point of the surface to a point, and the
// parameters along a line of points.
#pragma once

#include <cstddef>
#include <vector>

#include "core/vec3.h"
#include "geometry/surface.h"

namespace hexweave {

/// A place on a surface found by projection. Parameters may lie outside the range along which the
/// surface is closed, when they were found as a continuation.
struct SurfacePoint {
    SurfaceParameters parameters;
    Vec3 position;
    double distance = 0;
};

/// The parameters that differ from `at` by whole periods and are nearest to `reference`.
SurfaceParameters continued(const Surface& surface, const SurfaceParameters& at,
                            const SurfaceParameters& reference);

/// The corners of an axis-parallel box.
struct SampleBox {
    Vec3 low;
    Vec3 high;
};

/// Finds nearest points; keeps its own copy of the surface and a net of samples of it.
class SurfaceProjection {
public:
    explicit SurfaceProjection(Surface surface);

    const Surface& surface() const { return surface_; }
    /// The box around the surface: around the samples, with room for what bulges between them.
    const SampleBox& box() const { return box_; }
    /// The diagonal of the box around the samples.
    double size() const { return size_; }

    /// The point of the surface nearest to p, from the samples that are nearer than their
    /// neighbours; the first of equals. Parameters are in the range. The position of a point on the
    /// surface is met to 1e-12 of its size, also at edges that shrink to a line or a point, where
    /// its parameters are less accurate or not even unique.
    SurfacePoint nearest(const Vec3& p) const;

    /// The nearest point that is reached downhill from `start`, whose parameters it continues.
    SurfacePoint nearest_from(const Vec3& p, const SurfaceParameters& start) const;

    /// Where to start from towards the nearest point: the nearest sample, a little inside of the
    /// range, for on its ends derivatives may vanish.
    SurfaceParameters nearest_sample(const Vec3& p) const;

    /// The parameters along a line of points on the surface, each continued from the one before:
    /// where the line crosses a seam they leave the range.
    std::vector<SurfacePoint> along(const std::vector<Vec3>& line) const;

private:
    static constexpr int intervals_ = 48;

    static std::size_t net_node(int i, int j) {
        return static_cast<std::size_t>(i) +
               static_cast<std::size_t>(j) * (static_cast<std::size_t>(intervals_) + 1);
    }
    SurfaceParameters net_parameters(int i, int j) const;
    double bulge() const;

    Surface surface_;
    std::vector<Vec3> samples_;
    SampleBox box_;
    double size_ = 0;
};

}  // namespace hexweave
