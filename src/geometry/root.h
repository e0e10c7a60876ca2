// SPDX-License-Identifier: Apache-2.0
// The root of a function of one variable inside a bracket.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexweave {

/// The root of f between a and b, where f has opposite signs (or is zero at one of them), to the
/// last few bits: inverse quadratic interpolation where it is safe, else bisection [Chandrupatla
/// 1997, Advances in Engineering Software 28, 145-149]. Of the last two points the one with the
/// smaller |f| is returned.
template <class Function>
double bracketed_root(Function&& f, double a, double b) {
    constexpr int most_steps = 200;
    double fa = f(a);
    double fb = f(b);
    if (fa == 0) return a;
    if (fb == 0) return b;
    double c = a;
    double fc = fa;
    double t = 0.5;
    for (int step = 0; step < most_steps; ++step) {
        const double x = a + t * (b - a);
        const double fx = f(x);
        if (std::signbit(fx) == std::signbit(fa)) {
            c = a;
            fc = fa;
        } else {
            c = b;
            fc = fb;
            b = a;
            fb = fa;
        }
        a = x;
        fa = fx;
        const double best = std::abs(fb) < std::abs(fa) ? b : a;
        const double tolerance = 2 * std::numeric_limits<double>::epsilon() * std::abs(best);
        const double limit = tolerance / std::abs(b - c);
        if (fa == 0 || fb == 0 || limit > 0.5 || !(std::abs(b - a) > tolerance)) return best;
        const double xi = (a - b) / (c - b);
        const double phi = (fa - fb) / (fc - fb);
        if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi) {
            t = fa / (fb - fa) * fc / (fb - fc) +
                (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
        } else {
            t = 0.5;
        }
        t = std::clamp(t, limit, 1 - limit);
    }
    return std::abs(fb) < std::abs(fa) ? b : a;
}

}  // namespace hexweave
