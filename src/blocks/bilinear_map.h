// SPDX-License-Identifier: Apache-2.0
// The algebraic bilinear map from computational to parameter space of a block: every grid plane is
// a bilinear surface of the unit cube, spanned by the normalized arc lengths on its four edges.
#pragma once

#include <array>

#include "core/field.h"
#include "elliptic/elliptic_solver.h"
#include "faces/edge_functions.h"

namespace hexweave {

/// Something for each of a block's twelve edges: [axis][number], where the number is that of
/// EdgeStations: 0 to 3 for the edges at (min, min), (max, min), (min, max), (max, max) of the
/// other two axes, ascending.
template <class T>
using PerBlockEdge = std::array<std::array<T, 4>, 3>;

struct CubePoint {
    double s = 0;
    double t = 0;
    double u = 0;
};

/// The normalized arc lengths at one node's station on the twelve edges: of s on the edges at
/// (t, u) = (0,0), (1,0), (0,1), (1,1); of t at the same (s, u); of u at the same (s, t).
struct EdgeStations {
    std::array<double, 4> s{};
    std::array<double, 4> t{};
    std::array<double, 4> u{};
};

/// The point of the unit cube where the three bilinear surfaces through the stations meet. For
/// given u the first two equations are a straight-line map with a closed form; what is left is one
/// equation in u with a change of sign over [0, 1], solved by Newton's method within a bracket. So
/// it never fails and never leaves the cube, as the fixed point and Newton's method in three
/// variables may. At the boundary (four stations 0, or 1) it is exact.
/// [Spekreijse & Boerstoel 1996, eqs. (90)-(92)]
CubePoint bilinear_point(const EdgeStations& stations);

/// The parameters (s, t, u) of every node of a block, its sides included, from its boundary points.
/// The edge functions of its edges are their normalized arc lengths with these exponents.
ParameterField bilinear_map(const PointField& boundary,
                            const PerBlockEdge<EndExponents>& exponents = {});

}  // namespace hexweave
