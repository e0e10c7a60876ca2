// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/curve.h"
#include "geometry/quadrature.h"

namespace hexweave {

namespace {

double speed(const Curve& curve, double parameter) {
    return norm(evaluate_derivative(curve, parameter));
}

/// Panels from a to b (a < b) on each of which the length is a smooth function.
std::vector<Panel> length_panels(const Curve& curve, double a, double b) {
    std::vector<double> ends{a};
    const std::vector<double> joints = joints_between(curve, a, b);
    ends.insert(ends.end(), joints.begin(), joints.end());
    ends.push_back(b);
    const auto integrand = [&](double t) { return speed(curve, t); };
    double estimate = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        estimate += gauss_legendre(integrand, ends[k], ends[k + 1]);
    }
    std::vector<Panel> panels;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const std::vector<Panel> more = adaptive_panels(integrand, ends[k], ends[k + 1], estimate);
        panels.insert(panels.end(), more.begin(), more.end());
    }
    return panels;
}

/// The parameter at arc length `target` from parameter `a`, on the way to parameter `b` within one
/// panel of length `panel_length`: Newton's method, kept in its bracket by bisection.
double invert_panel(const Curve& curve, double a, double b, double panel_length, double target) {
    constexpr int most_steps = 60;
    const auto integrand = [&](double t) { return speed(curve, t); };
    const double direction = b > a ? 1 : -1;
    double low = a;   // too short
    double high = b;  // too long
    double t = a + (b - a) * (target / panel_length);
    for (int step = 0; step < most_steps; ++step) {
        const double excess = direction * gauss_legendre(integrand, a, t) - target;
        (excess > 0 ? high : low) = t;
        const double rate = speed(curve, t);
        double next = t - direction * excess / rate;
        if (!(direction * (next - low) >= 0 && direction * (high - next) >= 0)) {
            next = low + 0.5 * (high - low);
        }
        // Newton's method converges quadratically: a small step is the last one.
        if (std::abs(next - t) <= 1e-11 * std::abs(next - a)) return next;
        t = next;
    }
    return t;
}

}  // namespace

double arc_length(const Curve& curve, double a, double b) {
    if (a == b) return 0;
    double sum = 0;
    for (const Panel& panel : length_panels(curve, std::min(a, b), std::max(a, b))) {
        sum += panel.integral;
    }
    return sum;
}

double parameter_at_fraction(const Curve& curve, double fraction) {
    const ArcLengthTable table(curve, curve.begin, curve.end);
    return table.parameter_at(fraction * table.length());
}

ArcLengthTable::ArcLengthTable(Curve curve, double from, double to) : curve_(std::move(curve)) {
    std::vector<Panel> panels;
    if (from != to) panels = length_panels(curve_, std::min(from, to), std::max(from, to));
    if (to < from) std::reverse(panels.begin(), panels.end());
    parameters_.push_back(from);
    lengths_.push_back(0);
    for (const Panel& panel : panels) {
        parameters_.push_back(from < to ? panel.b : panel.a);
        lengths_.push_back(lengths_.back() + panel.integral);
    }
}

double ArcLengthTable::parameter_at(double s) const {
    if (s <= 0) return parameters_.front();
    if (s >= length()) return parameters_.back();
    const auto above = std::upper_bound(lengths_.begin(), lengths_.end(), s);
    const auto k = static_cast<std::size_t>(above - lengths_.begin());
    const double a = parameters_[k - 1];
    const double b = parameters_[k];
    const double panel_length = lengths_[k] - lengths_[k - 1];
    const double after = s - lengths_[k - 1];
    const double before = lengths_[k] - s;
    if (after == 0) return a;
    // From the nearer end, so that the distance to it keeps its digits.
    return after <= before ? invert_panel(curve_, a, b, panel_length, after)
                           : invert_panel(curve_, b, a, panel_length, before);
}

double ArcLengthTable::length_to(double parameter) const {
    const double direction = parameters_.back() >= parameters_.front() ? 1 : -1;
    const auto beyond =
        std::upper_bound(parameters_.begin(), parameters_.end(), parameter,
                         [&](double p, double end) { return direction * (end - p) > 0; });
    if (beyond == parameters_.begin()) return 0;
    if (beyond == parameters_.end()) return length();
    const auto k = static_cast<std::size_t>(beyond - parameters_.begin()) - 1;
    const auto integrand = [&](double t) { return speed(curve_, t); };
    return lengths_[k] + std::abs(gauss_legendre(integrand, parameters_[k], parameter));
}

}  // namespace hexweave
