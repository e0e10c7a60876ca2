// SPDX-License-Identifier: Apache-2.0
#include "elliptic/convergence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hexweave {

namespace {

constexpr double best_rate = 0.1;
constexpr double worst_rate = 0.99;
constexpr double unknown_rate = 0.9;

/// The first step from a start grid says little: a rate seen from it is not believed beyond this.
constexpr double best_first_rate = 0.3;

}  // namespace

double convergence_rate(const std::vector<double>& steps) {
    const std::size_t n = steps.size();
    if (n < 2 || steps[n - 2] == 0) return unknown_rate;
    const double last = steps[n - 1] / steps[n - 2];
    if (n == 2) return std::clamp(last, best_first_rate, worst_rate);
    const double mean = std::sqrt(steps[n - 1] / steps[n - 3]);
    return std::clamp(std::max(last, mean), best_rate, worst_rate);
}

bool has_converged(const std::vector<double>& steps, double tolerance) {
    if (steps.empty()) return false;
    if (steps.back() == 0) return true;
    const double rate = convergence_rate(steps);
    return steps.back() < tolerance && steps.back() * rate / (1 - rate) < tolerance;
}

}  // namespace hexweave
