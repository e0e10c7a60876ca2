// SPDX-License-Identifier: Apache-2.0
// Numerical integration: Gauss-Legendre quadrature, and its adaptive use.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hexweave {

/// One positive node of the 16-point Gauss-Legendre rule on [-1, 1] and its weight; the rule is
/// symmetric.
struct GaussNode {
    double place;
    double weight;
};

/// [Abramowitz & Stegun 1964, table 25.4].
inline constexpr std::array<GaussNode, 8> gauss_nodes{
    {{0.0950125098376374401853, 0.1894506104550684962854},
     {0.2816035507792589132305, 0.1826034150449235888668},
     {0.4580167776572273863424, 0.1691565193950025381893},
     {0.6178762444026437484467, 0.1495959888165767320815},
     {0.7554044083550030338951, 0.1246289712555338720525},
     {0.8656312023878317438805, 0.0951585116824927848099},
     {0.9445750230732325760779, 0.0622535239386478928628},
     {0.9894009349916499325962, 0.0271524594117540948518}}};

/// The integral of f from a to b by 16 points; exact for polynomials up to degree 31.
template <class Function>
double gauss_legendre(Function&& f, double a, double b) {
    const double middle = 0.5 * (a + b);
    const double half = 0.5 * (b - a);
    double sum = 0;
    for (const GaussNode& node : gauss_nodes) {
        sum += node.weight * (f(middle - half * node.place) + f(middle + half * node.place));
    }
    return half * sum;
}

/// A piece of the range of integration over which the 16-point rule is accurate.
struct Panel {
    double a;
    double b;
    double integral;
};

/// Splits the range from a to b (a < b) into panels, in ascending order, halving until the rule on
/// the whole and on the halves agree to 1e-11 of the piece, or to 1e-15 of `scale`, and keeping the
/// halves, which are far better where f is smooth. Ends in any case: a function that is nowhere
/// smooth costs about `most_panels`.
template <class Function>
std::vector<Panel> adaptive_panels(Function&& f, double a, double b, double scale) {
    constexpr std::size_t most_panels = 4096;
    constexpr double smallest = 1e-15;
    std::vector<Panel> done;
    std::vector<Panel> open{{a, b, gauss_legendre(f, a, b)}};
    while (!open.empty()) {
        const Panel panel = open.back();
        open.pop_back();
        const double middle = 0.5 * (panel.a + panel.b);
        const Panel left{panel.a, middle, gauss_legendre(f, panel.a, middle)};
        const Panel right{middle, panel.b, gauss_legendre(f, middle, panel.b)};
        const double finer = left.integral + right.integral;
        const double change = std::abs(finer - panel.integral);
        if (change <= 1e-11 * std::abs(finer) || change <= smallest * scale ||
            panel.b - panel.a <= smallest * (b - a) || done.size() >= most_panels) {
            done.push_back(left);
            done.push_back(right);
        } else {
            open.push_back(right);
            open.push_back(left);
        }
    }
    return done;
}

}  // namespace hexweave
