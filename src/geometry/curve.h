// SPDX-License-Identifier: Apache-2.0
// Curves: shapes without points. A curve is a position and its derivative over a parameter range;
// every family (line, circle, spline, airfoil, formula, ...) is a function that returns one.
#pragma once

#include <functional>
#include <vector>

#include "core/vec3.h"

namespace hexweave {

/// A regular parametrized curve. `position` and `derivative` must be safe to call from several
/// threads at once. A closed curve may be evaluated outside [begin, end]: it wraps round.
struct Curve {
    std::function<Vec3(double)> position;
    std::function<Vec3(double)> derivative;
    double begin = 0;
    double end = 1;
    bool closed = false;
    std::vector<double> breaks;  ///< interior parameters where a derivative of any order jumps

    double period() const { return end - begin; }
};

/// Position and derivative at a parameter. Where the derivative jumps it is that of the piece
/// behind (of greater parameters). Precondition: begin <= parameter <= end unless closed.
Vec3 evaluate(const Curve& curve, double parameter);
Vec3 evaluate_derivative(const Curve& curve, double parameter);

/// Where the curve is not smooth strictly between the parameters a and b (a < b): breaks and, on a
/// closed curve, its seam, in every period that the range touches. Ascending.
std::vector<double> joints_between(const Curve& curve, double a, double b);

/// The length of the curve from parameter a to parameter b (positive also when b < a), accurate to
/// about 1e-12 of the piece's own length. Splits at the breaks.
double arc_length(const Curve& curve, double a, double b);

/// A place on a curve found by projection.
struct CurvePoint {
    double parameter = 0;
    Vec3 position;
    double distance = 0;
};

/// The point of the curve nearest to p; the parameter accurate to rounding where the foot is
/// regular. Ends and breaks are hit exactly. On a closed curve the parameter lies in [begin, end).
CurvePoint project(const Curve& curve, const Vec3& p);

/// The parameter at a fraction of the whole curve's arc length, 0 <= fraction <= 1.
double parameter_at_fraction(const Curve& curve, double fraction);

/// Arc length along a piece of a curve, tabulated for repeated inversion. The piece runs from
/// parameter `from` to parameter `to`, which may be smaller than `from`. The table keeps its own
/// copy of the curve.
class ArcLengthTable {
public:
    ArcLengthTable(Curve curve, double from, double to);

    double length() const { return lengths_.back(); }
    /// The parameter at arc length s from the start, 0 <= s <= length(); s is met to about 1e-13 of
    /// the length and, near the ends, to 1e-9 of s (of length - s) itself, so that a first cell of
    /// 1e-8 of the length is still met accurately. That holds as far as the parameter and s can
    /// tell it: beside a parameter of 1 they have no digits below 1e-16.
    double parameter_at(double s) const;
    /// Arc length from the start to a parameter of the piece.
    double length_to(double parameter) const;

private:
    Curve curve_;
    std::vector<double> parameters_;  ///< ends of the panels, from `from` to `to`
    std::vector<double> lengths_;     ///< arc length up to there
};

}  // namespace hexweave
