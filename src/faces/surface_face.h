// SPDX-License-Identifier: Apache-2.0
// Faces on surfaces of a given shape: every point is a point of the surface, and the elliptic grid
// depends on the shape alone, not on how the surface is parametrized.
#pragma once

#include "core/field.h"
#include "elliptic/elliptic_solver.h"
#include "elliptic/solve_result.h"
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

    /// Moves interior points that were moved off the surface to the nearest ones on it.
    void project_interior(PointField& points);

    /// Solves the Laplace-Beltrami equations for s and t on the grid of `points`, with the boundary
    /// values of `parameters`, and moves every interior node to where they have the values of
    /// `parameters`; and again on the grid that results, until nodes move by less than the
    /// tolerance. So the grid does not depend on the grid that it began with, nor on the
    /// parametrization. In the result `cycles` are the solver's, `history` has the displacement of
    /// every pass in cells.
    /// [Spekreijse & Boerstoel 1996, section 4.2, steps 3 to 5, repeated; by finite elements, for
    /// with the paper's finite volumes a node among neighbours that are displaced against it does
    /// not come to rest]
    SolveResult solve(PointField& points, const ParameterField& parameters,
                      const EllipticOptions& options);

private:
    /// Moves the nodes of one pass; returns the greatest move in cells.
    double move_nodes(const Field& s, const Field& t, const ParameterField& wanted);

    SurfaceProjection projection_;
    PointField at_;
};

}  // namespace hexweave
