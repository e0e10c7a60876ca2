// SPDX-License-Identifier: Apache-2.0
// The algebraic straight-line map from computational to parameter space of a face: grid lines are
// straight lines of the unit square between the normalized arc lengths on opposite sides.
#pragma once

#include <array>

#include "core/field.h"
#include "elliptic/elliptic_solver.h"
#include "faces/edge_functions.h"

namespace hexweave {

struct SquarePoint {
    double s = 0;
    double t = 0;
};

/// The value at fraction f of the way from a to b: exactly a at 0, b at 1, and a wherever a = b;
/// accurate relative to its distance from the nearer end.
double between(double a, double b, double f);

/// The point of the unit square where the line from (s_jmin, 0) to (s_jmax, 1) crosses the line
/// from (0, t_imin) to (1, t_imax), in closed form. On the boundary (all arguments of one kind 0,
/// or 1) it returns the arguments to the bit.
/// [Spekreijse & Boerstoel 1996, eqs. (39), (40)]
SquarePoint straight_line_point(double s_jmin, double s_jmax, double t_imin, double t_imax);

/// The parameters (s, t) of every node of a face from its boundary points; u is left empty. The
/// edge functions of the sides imin, imax, jmin, jmax are their normalized arc lengths with these
/// exponents.
/// [Spekreijse & Boerstoel 1996, eqs. (30)-(40)]
ParameterField straight_line_map(const PointField& boundary,
                                 const std::array<EndExponents, 4>& exponents = {});

}  // namespace hexweave
