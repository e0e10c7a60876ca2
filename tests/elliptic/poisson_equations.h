// SPDX-License-Identifier: Apache-2.0
// The discrete grid equations, written out as they stand in the paper and evaluated in double
// precision at one node: control functions and all. Nothing of the solver is used.
#pragma once

#include "core/field.h"
#include "elliptic/elliptic_solver.h"

namespace hexweave::shapes {

/// The left-hand side of the Poisson system at an interior node, over the sum of its
/// coefficients with the node itself: how far the node would go if it alone were moved to fulfil
/// its equation. [Spekreijse & Boerstoel 1996, eqs. (19), (24); of blocks (83), (86)]
Vec3 unfulfilled(const PointField& points, const ParameterField& parameters, int i, int j, int k);

/// The largest of these over the interior nodes, in cells: along the contravariant base vectors.
double largest_unfulfilled(const PointField& points, const ParameterField& parameters);

}  // namespace hexweave::shapes
