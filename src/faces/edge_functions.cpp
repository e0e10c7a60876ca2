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

std::vector<std::vector<double>> parallel_edge_functions(
    const std::vector<std::vector<Vec3>>& lines, const std::vector<EndExponents>& exponents) {
    std::vector<std::vector<double>> values(lines.size());
    for (std::size_t n = 0; n < lines.size(); ++n) {
        if (has_length(lines[n])) values[n] = edge_function(lines[n], exponents[n]);
    }
    const std::vector<std::vector<double>> own = values;
    for (std::size_t n = 0; n < lines.size(); ++n) {
        // The bits of the number are the ends of the other axes: neighbours first.
        for (std::size_t across = 1; across < lines.size() && values[n].empty(); ++across) {
            values[n] = own[n ^ across];
        }
        for (std::size_t m = 0; values[n].size() < lines[n].size(); ++m) {
            values[n].push_back(static_cast<double>(m) / static_cast<double>(lines[n].size() - 1));
        }
    }
    return values;
}

}  // namespace hexweave
