// SPDX-License-Identifier: Apache-2.0
// Surfaces through a rectangular array of points.
#pragma once

#include <string>
#include <vector>

#include "core/vec3.h"
#include "geometry/surface.h"

namespace hexweave {

/// count_u * count_v points, the i-th along u and j-th along v at i + j * count_u.
struct ControlMesh {
    int count_u = 0;
    int count_v = 0;
    std::vector<Vec3> points;
};

/// What is wrong with a mesh, or nothing: at least two points each way, all finite, and no two
/// neighbouring lines of points that are the same all along (counted from 1).
std::string fault_of(const ControlMesh& mesh);

/// The interpolating surface: a bicubic polynomial between each four points, with one derivative by
/// u, by v and by both at each point, so that it is continuously differentiable
/// [Spekreijse & Boerstoel 1996, section 4.3]. u and v run from 0 to 1, between lines of points by
/// the distances of the points, in the mean over the lines. Derivatives at a point are those of the
/// polynomial of fourth degree through it and its two neighbours on either side (shifted near the
/// ends), and periodic where the surface is closed: so the surface is exact for polynomials up to
/// the third degree. Closed along a parameter where the first and last line of points are the same.
/// Precondition: no fault_of(mesh).
Surface control_surface(const ControlMesh& mesh);

}  // namespace hexweave
