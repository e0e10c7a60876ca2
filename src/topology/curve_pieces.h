// SPDX-License-Identifier: Apache-2.0
// Which pieces of a curve lead from one of its points to another.
#pragma once

#include <vector>

#include "geometry/curve.h"

namespace hexweave {

/// A piece of a curve, run through from parameter `from` to parameter `to`; outside the range where
/// it crosses the seam of a closed curve.
struct CurvePiece {
    double from = 0;
    double to = 0;
};

/// The diagonal of the box around the curve, for tolerances: to a few per cent.
double size_of(const Curve& curve);

/// The parameters at which a curve passes a point that it is known to pass at `parameter`: the
/// parameter itself or, where an open curve's two ends meet in that point, both ends.
std::vector<double> passings(const Curve& curve, double parameter);

/// All pieces that lead from one of the parameters `from` to one of `to`. On a closed curve
/// forwards and backwards. From a point to itself: once round in the curve's own direction, or none
/// where the curve does not return.
std::vector<CurvePiece> pieces_between(const Curve& curve, const std::vector<double>& from,
                                       const std::vector<double>& to, bool same_point);

/// Whether the piece passes `parameter` strictly between its ends.
bool passes(const Curve& curve, const CurvePiece& piece, double parameter);

}  // namespace hexweave
