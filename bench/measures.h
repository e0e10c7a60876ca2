// SPDX-License-Identifier: Apache-2.0
// What is believed of a grid: its cells, its distance from the tightly converged one in cells, and
// how well it satisfies the discrete equations. No code is shared with any solver.
#pragma once

#include "core/field.h"
#include "elliptic/elliptic_solver.h"

namespace hexweave::bench {

struct GridQuality {
    long folded = 0;  ///< cells, flat corners of 180-degree edges apart
    long flat_corners = 0;
    double least_scaled_jacobian = 0;
};

/// By the program's own definition of folded and flat. A planar face is measured against +z.
GridQuality grid_quality(const PointField& points);

/// Bounds from above of |a^i . (x - reference)| over all interior points and directions, with the
/// contravariant base vectors a^i of `reference`, index spacing 1 (on a face those in its tangent
/// plane, and the normal over the root of the cell's area). NaN where any point is.
double error_in_cells(const PointField& points, const PointField& reference);

/// The largest ratio of two neighbouring cells along a grid line, at nodes that differ between
/// `points` and `other` or lie beside one that does: the seam of a patch. 1 where none differs.
double size_ratio_where_moved(const PointField& points, const PointField& other);

/// The largest residual of the grid equations (24), (86), over the centre of their stencil and in
/// cells of the grid itself. The control functions (19), (83) are formed in full, by differences of
/// the parameters. [Spekreijse & Boerstoel 1996]
double residual_in_cells(const PointField& points, const ParameterField& parameters);

}  // namespace hexweave::bench
