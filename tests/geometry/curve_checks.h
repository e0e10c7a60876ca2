// SPDX-License-Identifier: Apache-2.0
// Checks that every family of curves must pass.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/curve.h"

namespace hexweave {

/// The greatest error of the derivative, relative to its own size, against central differences of
/// the position between the breaks (which err by about 1e-8 themselves).
inline double derivative_error(const Curve& curve) {
    constexpr int samples = 200;
    const double step = 1e-5 * curve.period();
    double worst = 0;
    for (int k = 0; k < samples; ++k) {
        const double t = curve.begin + curve.period() * (k + 0.5) / samples;
        const bool at_break = std::any_of(curve.breaks.begin(), curve.breaks.end(),
                                          [&](double at) { return std::abs(at - t) <= step; });
        if (at_break) continue;
        const Vec3 difference =
            (evaluate(curve, t + step) - evaluate(curve, t - step)) / (2 * step);
        const Vec3 derivative = evaluate_derivative(curve, t);
        worst = std::max(worst, distance(difference, derivative) / norm(derivative));
    }
    return worst;
}

/// The greatest distance between two curves at the same fractions of their parameters.
inline double greatest_distance(const Curve& a, const Curve& b) {
    constexpr int samples = 500;
    double worst = 0;
    for (int k = 0; k <= samples; ++k) {
        const double f = static_cast<double>(k) / samples;
        const Vec3 p = evaluate(a, a.begin + f * a.period());
        worst = std::max(worst, distance(p, evaluate(b, b.begin + f * b.period())));
    }
    return worst;
}

}  // namespace hexweave
