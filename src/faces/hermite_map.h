// SPDX-License-Identifier: Apache-2.0
// The algebraic map from computational to parameter space of a face whose grid lines meet chosen
// sides of the unit square at right angles: cubics, parabolas or straight lines between the values
// that the edge functions give on opposite sides.
#pragma once

#include <array>
#include <vector>

#include "core/field.h"
#include "elliptic/elliptic_solver.h"
#include "faces/straight_line_map.h"

namespace hexweave {

/// The parameter along each side of a face, node by node: t on imin and imax, s on jmin and jmax.
/// From exactly 0 to exactly 1, increasing.
using EdgeFunctions = std::array<std::vector<double>, 4>;

/// How a family of grid lines crosses the square: at right angles to the side it leaves, to the
/// side it reaches, to both or to neither.
struct LineEnds {
    bool upright_at_start = false;
    bool upright_at_end = false;

    /// The share of the far side's value at fraction f of the way: H_1 of eq. (49) where both ends
    /// are upright, a parabola where one is, f where none is. Exactly 0 at 0 and 1 at 1.
    double far_share(double f) const;
    double slope(double f) const;
};

/// Where the line s = (1 - H(t)) s_jmin + H(t) s_jmax meets the line
/// t = (1 - K(s)) t_imin + K(s) t_imax, with H and K the far shares of `lines_of_i` (lines of
/// constant i, from jmin to jmax) and `lines_of_j`. Newton's method on one equation in s within a
/// bracket, so it never fails and never leaves the square. With the arguments of a side (both of
/// one kind 0, or 1) it returns the other's value to the bit.
/// [Spekreijse & Boerstoel 1996, eqs. (47)-(49)]
SquarePoint curved_line_point(double s_jmin, double s_jmax, const LineEnds& lines_of_i,
                              double t_imin, double t_imax, const LineEnds& lines_of_j);

/// The parameters (s, t) of every node: grid lines meet the sides marked in `orthogonal` (imin,
/// imax, jmin, jmax) at right angles in the unit square; u is left empty.
ParameterField hermite_map(const EdgeFunctions& edges, const std::array<bool, 4>& orthogonal);

}  // namespace hexweave
