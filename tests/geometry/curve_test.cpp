// SPDX-License-Identifier: Apache-2.0
#include "geometry/curve.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "geometry/conics.h"
#include "geometry/formula.h"
#include "geometry/lines.h"
#include "geometry/naca.h"
#include "geometry/transform.h"

using namespace hexweave;

namespace {

constexpr double pi = std::numbers::pi;

/// y = x^3 over [0, 1].
Curve cubic_parabola() {
    Curve curve;
    curve.position = [](double t) { return Vec3{t, t * t * t, 0}; };
    curve.derivative = [](double t) { return Vec3{1, 3 * t * t, 0}; };
    return curve;
}

/// y = x^2 / 2 from x = a to x = b.
Curve parabola(double a, double b) {
    Curve curve;
    curve.position = [](double t) { return Vec3{t, t * t / 2, 0}; };
    curve.derivative = [](double t) { return Vec3{1, t, 0}; };
    curve.begin = a;
    curve.end = b;
    return curve;
}

/// Its arc length from 0 to x.
double parabola_length(double x) {
    return 0.5 * (x * std::sqrt(1 + x * x) + std::asinh(x));
}

Curve square() {
    return polyline({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}}).curve.value();
}

}  // namespace

TEST_CASE("the length of a circle, a parabola and an ellipse is exact") {
    CHECK(arc_length(circle({1, 2, 0}, 3), 0, 4) == Approx(6 * pi).epsilon(1e-14));
    CHECK(arc_length(parabola(0, 2), 0, 2) == Approx(parabola_length(2)).epsilon(1e-14));
    CHECK(arc_length(parabola(0, 2), 2, 0.5) ==
          Approx(parabola_length(2) - parabola_length(0.5)).epsilon(1e-14));
    // Perimeter 4 a E(e): a = 2, b = 1 [Abramowitz & Stegun 1964, table 17.1, by AGM].
    CHECK(arc_length(ellipse({}, 2, 1), 0, 4) == Approx(9.688448220547676).epsilon(1e-13));
}

TEST_CASE("the length of a very flat ellipse is accurate") {
    // a = 1, b = 0.001: Ramanujan's second formula fails here; the series of E near modulus 1 is
    // E = 1 + (L - 1/2) b^2 / 2 + 3 (L - 13/12) b^4 / 16, L = ln(4 / b).
    const double b = 1e-3;
    const double l = std::log(4 / b);
    const double e = 1 + (l - 0.5) * b * b / 2 + 3 * (l - 13.0 / 12) * b * b * b * b / 16;
    CHECK(arc_length(ellipse({}, 1, b), 0, 4) == Approx(4 * e).epsilon(1e-13));
}

TEST_CASE("the length of a piece is accurate relative to the piece") {
    CHECK(arc_length(parabola(0, 2), 0, 1e-9) == Approx(1e-9).epsilon(1e-13));
    CHECK(arc_length(parabola(0, 2), 1, 1) == 0);
}

TEST_CASE("the length splits at corners and across the seam of a closed curve") {
    CHECK(arc_length(square(), 0.5, 3.25) == Approx(2.75).epsilon(1e-15));
    CHECK(arc_length(square(), 3.5, 4.75) == Approx(1.25).epsilon(1e-15));
    CHECK(arc_length(square(), -0.5, 4.5) == Approx(5).epsilon(1e-15));
}

TEST_CASE("a kink that no break tells of is found by halving") {
    const Curve kinked = formula([](double t) { return Vec3{t, std::abs(t - 0.3), 0}; }, 0, 1);
    // Differences across the kink blur it over 8 steps of 2.4e-4.
    CHECK(arc_length(kinked, 0, 0.25) == Approx(0.25 * std::sqrt(2.0)).epsilon(1e-11));
    CHECK(arc_length(kinked, 0, 1) == Approx(std::sqrt(2.0)).epsilon(1e-2));
}

TEST_CASE("a closed curve wraps round and keeps its ends") {
    const Curve round = circle({}, 1);
    CHECK(evaluate(round, 0) == evaluate(round, 4));
    CHECK(evaluate(round, 5) == Vec3{0, 1, 0});
    CHECK(evaluate(round, -1) == Vec3{0, -1, 0});
    CHECK(evaluate_derivative(round, 9) == evaluate_derivative(round, 1));
}

TEST_CASE("a table inverts the arc length of a parabola") {
    const Curve curve = parabola(-1, 3);
    const double from = -0.5;
    const double to = 2.5;
    const double start = parabola_length(from);
    const ArcLengthTable table(curve, from, to);
    CHECK(table.length() == Approx(parabola_length(to) - start).epsilon(1e-14));
    for (int k = 0; k <= 50; ++k) {
        const double s = table.length() * k / 50;
        const double t = table.parameter_at(s);
        CHECK(std::abs(parabola_length(t) - start - s) < 1e-13 * table.length());
        CHECK(std::abs(table.length_to(t) - s) < 1e-13 * table.length());
    }
}

TEST_CASE("a table hits both ends and mirrors when run backwards") {
    const Curve curve = cubic_parabola();
    const ArcLengthTable forward(curve, 0.1, 0.9);
    const ArcLengthTable backward(curve, 0.9, 0.1);
    CHECK(forward.parameter_at(0) == 0.1);
    CHECK(forward.parameter_at(forward.length()) == 0.9);
    CHECK(backward.parameter_at(0) == 0.9);
    CHECK(backward.parameter_at(backward.length()) == 0.1);
    CHECK(forward.length() == Approx(backward.length()).epsilon(1e-15));
    for (int k = 1; k < 10; ++k) {
        const double s = forward.length() * k / 10;
        CHECK(forward.parameter_at(s) ==
              Approx(backward.parameter_at(backward.length() - s)).epsilon(1e-13));
        CHECK(backward.length_to(backward.parameter_at(s)) == Approx(s).epsilon(1e-13));
    }
}

TEST_CASE("a table meets tiny first and last cells to 1e-9 of themselves") {
    for (const double cell : {1e-4, 1e-6, 1e-8, 1e-10}) {
        // A parameter of 0 at the end of interest has digits to spare.
        const ArcLengthTable first(parabola(0, 2), 0, 2);
        const double s = cell * first.length();
        CHECK(parabola_length(first.parameter_at(s)) == Approx(s).epsilon(1e-9));
        const ArcLengthTable last(parabola(-2, 0), -2, 0);
        const double behind = last.length() - (last.length() - s);
        CHECK(parabola_length(-last.parameter_at(last.length() - s)) ==
              Approx(behind).epsilon(1e-9));
    }
}

TEST_CASE("a table crosses the seam of a closed curve") {
    const ArcLengthTable table(circle({}, 2), 3.5, 4.5);
    CHECK(table.length() == Approx(pi).epsilon(1e-14));
    CHECK(table.parameter_at(0.5 * table.length()) == Approx(4).epsilon(1e-14));
    const ArcLengthTable back(circle({}, 2), 0.5, -0.5);
    CHECK(back.parameter_at(0.25 * back.length()) == Approx(0.25).epsilon(1e-13));
}

TEST_CASE("fractions of a circle are fractions of its turn") {
    const Curve round = circle({}, 5);
    CHECK(parameter_at_fraction(round, 0.25) == Approx(1).epsilon(1e-14));
    CHECK(parameter_at_fraction(round, 0) == 0);
    CHECK(parameter_at_fraction(round, 1) == 4);
}

TEST_CASE("a point of a curve projects onto itself") {
    const Curve naca =
        naca_airfoil("2412", 1, AirfoilSide::whole, TrailingEdge::blunt).curve.value();
    for (const Curve& curve : {parabola(-1, 3), circle({1, 1, 0}, 2), square(), naca}) {
        for (int k = 0; k < 97; ++k) {
            const double t = curve.begin + curve.period() * k / 97.0;
            const CurvePoint foot = project(curve, evaluate(curve, t));
            CHECK(foot.parameter == Approx(t).epsilon(1e-12).margin(1e-13));
            CHECK(foot.distance < 1e-14);
        }
    }
}

TEST_CASE("a foot off the curve is accurate to rounding") {
    const Curve round = circle({}, 2);
    for (int k = 0; k < 40; ++k) {
        const double angle = 0.1 + 2 * pi * k / 40;
        const CurvePoint foot = project(round, {5 * std::cos(angle), 5 * std::sin(angle), 0});
        CHECK(foot.parameter == Approx(std::fmod(angle, 2 * pi) / (pi / 2)).epsilon(1e-14));
        CHECK(foot.distance == Approx(3).epsilon(1e-14));
    }
}

TEST_CASE("projection hits ends, corners and the seam exactly") {
    const Curve open = parabola(1, 2);
    CHECK(project(open, {1, 0.5, 0}).parameter == 1);
    CHECK(project(open, {2, 2, 0}).parameter == 2);
    CHECK(project(open, {0, 0, 0}).parameter == 1);
    CHECK(project(open, {5, 9, 0}).parameter == 2);
    CHECK(project(square(), {1.5, 1.25, 0}).parameter == 2);
    CHECK(project(square(), {-0.5, -0.25, 0}).parameter == 0);
    CHECK(project(square(), {0, 0, 0}).parameter == 0);
    const Curve round = circle({}, 1);
    CHECK(project(round, {3, 0, 0}).parameter == 0);
    CHECK(project(round, {0, -3, 0}).parameter == 3);
    const CurvePoint below = project(round, {3, -1e-6, 0});
    CHECK(below.parameter == Approx(4 - 1e-6 / 3 / (pi / 2)).epsilon(1e-14));
    const Curve far_away = transformed(open, translation({1e6, -1e6, 0}));
    CHECK(project(far_away, evaluate(far_away, 1)).parameter == 1);
    CHECK(project(far_away, evaluate(far_away, 2)).parameter == 2);
}

TEST_CASE("a foot close to a break that is no corner is not drawn into it") {
    Curve curve = parabola(-1, 1);
    curve.breaks = {0.25};
    const double t = 0.25 + 1e-8;
    const Vec3 normal = Vec3{-t, 1, 0} / std::sqrt(1 + t * t);
    const CurvePoint foot = project(curve, evaluate(curve, t) + 0.5 * normal);
    CHECK(foot.parameter == Approx(t).epsilon(1e-14));
}

TEST_CASE("of several feet the nearest is found") {
    const Curve wave = formula(
        [](double t) {
            return Vec3{t, 0.2 * std::sin(40 * t), 0};
        },
        0, 2 * pi);
    for (int k = 1; k < 20; ++k) {
        const Vec3 p{0.3 * k, 0.25, 0};
        const CurvePoint foot = project(wave, p);
        double least = 1e9;
        for (int m = 0; m <= 100000; ++m) {
            least = std::min(least, distance(p, evaluate(wave, 2 * pi * m / 100000)));
        }
        CHECK(foot.distance <= least);
        CHECK(foot.distance == Approx(least).epsilon(1e-4));
    }
}
