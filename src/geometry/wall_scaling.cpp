// SPDX-License-Identifier: Apache-2.0
#include "geometry/wall_scaling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/assert.h"
#include "geometry/stretching.h"

namespace hexweave {

namespace {

/// 1 at x = 0, 0 at x = 1, level at both.
double falling_step(double x) {
    return 1 - x * x * (3 - 2 * x);
}

}  // namespace

std::vector<double> scaled_distances(const std::vector<double>& distances, double log_factor,
                                     double fade, std::size_t first) {
    return scaled_distances(distances, std::vector<double>(distances.size(), log_factor), fade,
                            first);
}

std::vector<double> scaled_distances(const std::vector<double>& distances,
                                     const std::vector<double>& log_factors, double fade,
                                     std::size_t first) {
    HEXWEAVE_ASSERT(log_factors.size() == distances.size());
    std::vector<double> scaled = distances;
    if (scaled.size() <= first || scaled[first] >= fade) return scaled;
    const double scales = std::log(fade / distances[first]);
    for (std::size_t n = 1; n < scaled.size() && distances[n] < fade; ++n) {
        const double x = n < first ? 0 : std::log(distances[n] / distances[first]) / scales;
        scaled[n] = distances[n] * std::exp(log_factors[n] * falling_step(x));
    }
    return scaled;
}

double greatest_growth(const std::vector<double>& distances) {
    double greatest = 1;
    for (std::size_t n = 1; n < distances.size(); ++n) {
        const double cell = distances[n] - distances[n - 1];
        if (!(cell > 0)) return std::numeric_limits<double>::infinity();
        if (n == 1) continue;
        const double ratio = cell / (distances[n - 1] - distances[n - 2]);
        greatest = std::max({greatest, ratio, 1 / ratio});
    }
    return greatest;
}

std::vector<double> held_tanh_fractions(int cells, double first, double natural, double within,
                                        bool at_end, int refinement) {
    const std::vector<double> law = tanh_fractions(cells, natural, std::nullopt, refinement);
    const auto one_cell = static_cast<std::size_t>(refinement);
    const std::vector<double> held =
        scaled_distances(law, std::log(first / law[one_cell]), within, one_cell);
    return at_end ? reversed_fractions(held) : held;
}

}  // namespace hexweave
