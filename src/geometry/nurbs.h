// SPDX-License-Identifier: Apache-2.0
// Curves and surfaces given by control points, knots and weights: non-uniform rational B-splines.
#pragma once

#include <string>
#include <vector>

#include "core/vec3.h"
#include "geometry/curve.h"
#include "geometry/surface.h"

namespace hexweave {

/// The greatest degree that is evaluated.
inline constexpr int greatest_nurbs_degree = 25;

/// A surface: count_u * count_v control points, the i-th along u and j-th along v at
/// i + j * count_u, and as many weights (none: all 1). count + degree + 1 knots for each parameter.
struct NurbsNet {
    int degree_u = 1;
    int degree_v = 1;
    int count_u = 0;
    int count_v = 0;
    std::vector<double> knots_u;
    std::vector<double> knots_v;
    std::vector<Vec3> control;
    std::vector<double> weights;
};

/// A curve: count + degree + 1 knots for count control points and weights (none: all 1).
struct NurbsPolygon {
    int degree = 1;
    std::vector<double> knots;
    std::vector<Vec3> control;
    std::vector<double> weights;
};

/// What is wrong with a row of knots ("the knots descend from 1 to 0.5"), or nothing: `count` +
/// `degree` + 1 finite numbers, not descending, an inner one not more than `degree` times and one
/// at an end not more than `degree` + 1 times (so that there is no gap), and a range that is not
/// empty.
std::string knots_fault(const std::vector<double>& knots, int degree, int count);

/// What is wrong with the numbers of control points and weights, a degree, a knot or a weight; or
/// nothing. The knots of a surface are told as "the knots of u".
std::string fault_of(const NurbsNet& net);
std::string fault_of(const NurbsPolygon& polygon);

/// The surface over its knots' own range, from knot [degree] to knot [count] of each parameter, by
/// the recurrence of [de Boor 1972] with its exact first derivatives. Where a derivative jumps it
/// is that of the piece behind (of greater parameters). Closed along a parameter where its two ends
/// coincide, to 1e-12 of its extent. Precondition: no fault_of(net).
Surface nurbs_surface(NurbsNet net);

/// The curve likewise; its inner knots are breaks. Precondition: no fault_of(polygon).
Curve nurbs_curve(NurbsPolygon polygon);

}  // namespace hexweave
