// SPDX-License-Identifier: Apache-2.0
// The elliptic grid of a face whose points are bound to a shape: harmonic functions on the grid
// there is say where its nodes belong, and they are moved there within the shape, again and again.
#pragma once

#include <functional>
#include <optional>

#include "core/field.h"
#include "elliptic/elliptic_solver.h"
#include "elliptic/solve_result.h"

namespace hexweave {

/// A face whose interior points can only be moved within a shape. All functions keep the shape's
/// own record of the points in step with them.
struct BoundFace {
    /// Moves every interior node to where (s, t), given at the nodes, have the wanted values;
    /// returns the greatest move in cells.
    std::function<double(PointField& points, const Field& s, const Field& t,
                         const ParameterField& wanted)>
        move;
    /// Moves interior points that have left the shape to the nearest ones on it.
    std::function<void(PointField& points)> project;
    /// Remembers the grid as it is, and goes back to the one remembered.
    std::function<void(const PointField& points)> keep;
    std::function<void(PointField& points)> restore;
};

/// Solves the Laplace-Beltrami equations for s and t on the grid of `points`, with the boundary
/// values of `parameters`, and moves every interior node to where they have the values of
/// `parameters`; and again on the grid that results, until nodes move by less than the tolerance.
/// So the grid does not depend on the grid that it began with, nor on how the shape is parametrized
/// or cut into patches. In the result `cycles` are the solver's, `history` has the displacement of
/// every pass in cells. [Spekreijse & Boerstoel 1996, section 4.2, steps 3 to 5, repeated; by
/// finite elements, for with the paper's finite volumes a node among neighbours that are displaced
/// against it does not come to rest]
SolveResult solve_bound(PointField& points, const ParameterField& parameters,
                        const EllipticOptions& options, const BoundFace& face);

/// Turns folded cells the right way round: untangles in space and brings the points back to the
/// shape, a few times in turn, as long as it helps. Nothing where no cell is folded. Points between
/// the sides are had by transfinite interpolation with `parameters` where none else serve.
std::optional<Untangling> untangle_bound(PointField& points, const ParameterField& parameters,
                                         const BoundFace& face);

}  // namespace hexweave
