// SPDX-License-Identifier: Apache-2.0
// Edge functions: the value of a parameter at the points of an edge, from which the algebraic maps
// are built. The normalized arc length, with an exponent at an end where two sides meet flat.
#pragma once

#include <vector>

#include "core/vec3.h"

namespace hexweave {

/// The exponents p at the two ends of an edge: near an end the edge function grows like the
/// distance to the power p. 1 is the arc length itself.
///
/// Where two sides meet at 180 degrees, a parameter that is constant on one of them and the arc
/// length on the other has a gradient that grows like the logarithm of the distance, across both
/// sides; so has the other parameter, and grid lines leave nearly along each other. With 1/2, as in
/// the conformal map of a half plane to a right angle, lines would cross at right angles.
struct EndExponents {
    double start = 1;
    double end = 1;

    friend bool operator==(const EndExponents&, const EndExponents&) = default;
};

/// The edge function at fraction f of the arc length: f^p with an exponent at the start alone,
/// 1 - (1 - f)^p at the end alone, and with p and q at start and end f^p / (f^p + (1 - f)^q), so
/// that it does not matter from where the edge is run through. Exactly 0 and 1 at the ends,
/// increasing, and f itself without exponents.
double edge_function(double fraction, const EndExponents& exponents);

/// The edge function at the points of a line.
std::vector<double> edge_function(const std::vector<Vec3>& line, const EndExponents& exponents);

/// The edge functions of the edges along one axis of a face (two: at the minimum and the maximum of
/// the other axis) or of a block (four, numbered as in EdgeStations). An edge that is a pole has no
/// arc length and takes the values of an edge beside it or, where all are poles, equal steps.
std::vector<std::vector<double>> parallel_edge_functions(
    const std::vector<std::vector<Vec3>>& lines, const std::vector<EndExponents>& exponents);

}  // namespace hexweave
