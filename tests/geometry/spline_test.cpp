// SPDX-License-Identifier: Apache-2.0
#include "geometry/spline.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "geometry/curve_checks.h"

using namespace hexweave;

namespace {

constexpr double pi = std::numbers::pi;

Vec3 cubic(double t) {
    return {t, 1 - 2 * t + 3 * t * t - t * t * t, 0.5 * t * t * t};
}
Vec3 cubic_rate(double t) {
    return {1, -2 + 6 * t - 3 * t * t, 1.5 * t * t};
}

std::vector<Vec3> on_cubic(const std::vector<double>& parameters) {
    std::vector<Vec3> points;
    points.reserve(parameters.size());
    for (const double t : parameters) points.push_back(cubic(t));
    return points;
}

double error_on_cubic(const Curve& curve) {
    double worst = 0;
    for (int k = 0; k <= 200; ++k) {
        const double t = curve.begin + curve.period() * k / 200;
        worst = std::max(worst, distance(evaluate(curve, t), cubic(t)));
        worst = std::max(worst, distance(evaluate_derivative(curve, t), cubic_rate(t)));
    }
    return worst;
}

/// The greatest distance of a closed spline through points of the unit circle from that circle.
double error_on_circle(int points) {
    std::vector<Vec3> on_circle;
    for (int k = 0; k < points; ++k) {
        const double angle = 2 * pi * (k + 0.3 * std::sin(6 * pi * k / points)) / points;
        on_circle.push_back({std::cos(angle), std::sin(angle), 0});
    }
    on_circle.push_back(on_circle.front());
    const Curve curve = spline(on_circle).curve.value();
    double worst = 0;
    for (int k = 0; k <= 5000; ++k) {
        const Vec3 p = evaluate(curve, curve.begin + curve.period() * k / 5000);
        worst = std::max(worst, std::abs(norm(p) - 1));
    }
    return worst;
}

}  // namespace

TEST_CASE("a not-a-knot spline is exact for cubics") {
    CHECK(error_on_cubic(spline_at({0, 0.4, 0.5, 1.3, 2}, on_cubic({0, 0.4, 0.5, 1.3, 2}))) <
          1e-13);
    CHECK(error_on_cubic(spline_at({-1, 0.1, 0.9, 2}, on_cubic({-1, 0.1, 0.9, 2}))) < 1e-13);
}

TEST_CASE("a spline with the right tangents is exact for cubics") {
    SplineEnds both;
    both.start_tangent = cubic_rate(0);
    both.end_tangent = cubic_rate(2);
    CHECK(error_on_cubic(spline_at({0, 2}, on_cubic({0, 2}), both)) < 1e-13);
    CHECK(error_on_cubic(spline_at({0, 0.3, 2}, on_cubic({0, 0.3, 2}), both)) < 1e-13);
    SplineEnds start;
    start.start_tangent = cubic_rate(0);
    CHECK(error_on_cubic(spline_at({0, 0.3, 2}, on_cubic({0, 0.3, 2}), start)) < 1e-13);
    SplineEnds end;
    end.end_tangent = cubic_rate(2);
    CHECK(error_on_cubic(spline_at({0, 0.3, 2}, on_cubic({0, 0.3, 2}), end)) < 1e-13);
}

TEST_CASE("three points make a parabola, two a straight line") {
    const auto parabola = [](double t) { return Vec3{t, t * t, 1 - t}; };
    const Curve curve = spline_at({0, 0.7, 2}, {parabola(0), parabola(0.7), parabola(2)});
    for (const double t : {0.2, 0.7, 1.1, 1.9}) {
        CHECK(distance(evaluate(curve, t), parabola(t)) < 1e-14);
    }
    const Curve line = spline({{0, 0, 0}, {3, 4, 0}}).curve.value();
    CHECK(line.end == 5);
    CHECK(distance(evaluate(line, 2.5), {1.5, 2, 0}) < 1e-15);
}

TEST_CASE("a natural spline has no curvature at its ends") {
    SplineEnds natural;
    natural.start = natural.end = SplineEnd::natural;
    const Curve curve = spline({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 2, 1}}, natural).curve.value();
    const double h = 1e-4;
    for (const double sign : {1.0, -1.0}) {
        const double at = sign > 0 ? curve.begin : curve.end;
        const Vec3 change =
            evaluate_derivative(curve, at + sign * h) - evaluate_derivative(curve, at);
        CHECK(norm(change) < 20 * h * h);  // linear curvature: the change is of second order
    }
}

TEST_CASE("a spline passes its points to the bit and is twice smooth there") {
    const std::vector<Vec3> points{{0.1, 0, 0}, {1, 1.3, 0.2}, {2.1, 0, 0}, {3, 2, 1}, {4, 2, 5}};
    const Curve curve = spline(points).curve.value();
    CHECK(evaluate(curve, curve.begin) == points.front());
    CHECK(evaluate(curve, curve.end) == points.back());
    CHECK(derivative_error(curve) < 1e-7);
    for (std::size_t k = 1; k < 4; ++k) {
        const double t = curve.breaks[k - 1];
        CHECK(evaluate(curve, t) == points[k]);
        const double h = 1e-5;
        const Vec3 before = evaluate_derivative(curve, t) - evaluate_derivative(curve, t - h);
        const Vec3 after = evaluate_derivative(curve, t + h) - evaluate_derivative(curve, t);
        CHECK(distance(before, after) < 100 * h * h);
    }
}

TEST_CASE("a closed spline converges with the fourth order and is smooth at its seam") {
    const double coarse = error_on_circle(24);
    const double fine = error_on_circle(48);
    CHECK(coarse < 1e-3);
    CHECK(std::log2(coarse / fine) > 3.7);
    CHECK(std::log2(coarse / fine) < 5);
    const Curve loop =
        spline({{1, 0, 0}, {0, 1.5, 0}, {-1, 0, 0}, {0, -1, 0.5}, {1, 0, 0}}).curve.value();
    CHECK(loop.closed);
    CHECK(evaluate(loop, loop.begin) == evaluate(loop, loop.end));
    CHECK(evaluate_derivative(loop, loop.begin) == evaluate_derivative(loop, loop.end));
    const double h = 1e-5;
    const Vec3 before =
        evaluate_derivative(loop, loop.end) - evaluate_derivative(loop, loop.end - h);
    const Vec3 after =
        evaluate_derivative(loop, loop.begin + h) - evaluate_derivative(loop, loop.begin);
    CHECK(distance(before, after) < 100 * h * h);
}

TEST_CASE("a closed spline may keep a corner where it closes") {
    SplineEnds corner;
    corner.corner = true;
    const Curve loop =
        spline({{1, 0, 0}, {0, 1, 0}, {-1, 0.5, 0}, {0, -1, 0}, {1, 0, 0}}, corner).curve.value();
    CHECK(loop.closed);
    CHECK(distance(evaluate_derivative(loop, loop.begin), evaluate_derivative(loop, loop.end)) >
          0.05);
}

TEST_CASE("tangents of a spline count by direction") {
    SplineEnds up;
    up.start_tangent = Vec3{0, 7, 0};
    const Curve curve = spline({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}}, up).curve.value();
    CHECK(distance(evaluate_derivative(curve, 0), {0, 1, 0}) < 1e-15);
}

TEST_CASE("points that make no spline are refused") {
    CHECK(spline({{0, 0, 0}}).error == "a spline needs at least two points");
    CHECK(spline({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}}).error == "points 2 and 3 coincide");
    CHECK(spline({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}).error ==
          "a closed spline needs at least three different points");
    SplineEnds none;
    none.end_tangent = Vec3{};
    CHECK(spline({{0, 0, 0}, {1, 0, 0}}, none).error == "a tangent of the spline has no length");
}
