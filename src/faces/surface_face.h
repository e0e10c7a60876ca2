// SPDX-License-Identifier: Apache-2.0
// Faces on surfaces of a given shape: every point is a point of the surface, and the elliptic grid
// depends on the shape alone, not on how the surface is parametrized.
#pragma once

#include "core/field.h"
#include "elliptic/elliptic_solver.h"
#include "faces/harmonic_iteration.h"
#include "faces/off_surface.h"
#include "geometry/surface_projection.h"

namespace hexweave {

/// The nodes of a face on a surface: parameters u and v of every node (as x and y of a planar
/// field). Along a closed parameter they may leave its range.
class SurfaceFace {
public:
    /// Inverts the boundary nodes of `points`, which lie on the surface, and interpolates (u, v)
    /// transfinitely with `parameters` as blending coordinates. Where that folds in the plane of u
    /// and v it is untangled there.
    SurfaceFace(const Surface& surface, const PointField& points, const ParameterField& parameters,
                bool start_folded = false);

    /// Sets the interior of `points` to the points of the surface at (u, v); boundary nodes stay.
    void evaluate_interior(PointField& points) const;

    /// How far the boundary nodes are off the surface.
    const OffSurface& off_surface() const { return off_; }

    /// For the solve and untangling; valid as long as this object stays where it is. The nodes move
    /// in the plane of the parameters.
    BoundFace bound();

private:
    double move_nodes(const Field& s, const Field& t, const ParameterField& wanted);
    void project_interior(PointField& points);

    SurfaceProjection projection_;
    OffSurface off_;
    PointField at_;
    PointField kept_;
};

}  // namespace hexweave
