// SPDX-License-Identifier: Apache-2.0
#include "faces/edge_functions.h"

#include <cmath>

#include "faces/arc_length.h"

namespace hexweave {

double edge_function(double fraction, const EndExponents& exponents) {
    const double rest = 1 - fraction;
    if (exponents.start == 1 && exponents.end == 1) return fraction;
    if (exponents.end == 1) return std::pow(fraction, exponents.start);
    if (exponents.start == 1) return 1 - std::pow(rest, exponents.end);
    const double from_start = std::pow(fraction, exponents.start);
    const double from_end = std::pow(rest, exponents.end);
    return from_start / (from_start + from_end);
}

std::vector<double> edge_function(const std::vector<Vec3>& line, const EndExponents& exponents) {
    std::vector<double> values = normalized_arc_length(line);
    for (double& value : values) value = edge_function(value, exponents);
    return values;
}

}  // namespace hexweave
