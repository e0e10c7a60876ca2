// SPDX-License-Identifier: Apache-2.0
// Curves on surfaces, and surfaces made of parts and of curves.
#include "geometry/surface_curves.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/conics.h"
#include "geometry/control_mesh.h"
#include "geometry/lines.h"
#include "geometry/surface_parts.h"

using namespace hexweave;
using std::numbers::pi;

namespace {

Surface tube() {
    return cone({0, 0, 0}, {0, 0, 3}, 2, 2);
}

/// A wavy sheet through 9 by 7 points.
Surface sheet() {
    ControlMesh mesh{9, 7, {}};
    for (int j = 0; j < 7; ++j) {
        for (int i = 0; i < 9; ++i) {
            mesh.points.push_back(
                {i + 0.3 * std::sin(j), j + 0.2 * std::cos(2.0 * i), std::sin(0.7 * i + 0.5 * j)});
        }
    }
    return control_surface(mesh);
}

/// The length of a fine polyline.
double polyline_length(const Curve& curve, int pieces) {
    double sum = 0;
    for (int n = 0; n < pieces; ++n) {
        sum += distance(curve.position(curve.begin + curve.period() * n / pieces),
                        curve.position(curve.begin + curve.period() * (n + 1) / pieces));
    }
    return sum;
}

}  // namespace

TEST_CASE("lines of equal longitude and latitude are half circles and circles") {
    const Surface ball = sphere({1, 2, 3}, 2);
    const Curve meridian = line_of_equal_u(ball, 0.3, -pi / 2, pi / 2);
    CHECK_FALSE(meridian.closed);
    CHECK(arc_length(meridian, meridian.begin, meridian.end) == Approx(2 * pi).epsilon(1e-13));
    const Curve circle = line_of_equal_v(ball, 0.5, 0, 2 * pi);
    CHECK(circle.closed);
    CHECK(arc_length(circle, circle.begin, circle.end) ==
          Approx(4 * pi * std::cos(0.5)).epsilon(1e-13));
    for (int n = 0; n <= 20; ++n) {
        const double t = 2 * pi * n / 20;
        CHECK(circle.position(t).z == Approx(3 + 2 * std::sin(0.5)).epsilon(1e-15));
    }
}

TEST_CASE("the image of a straight line on a cylinder is a helix") {
    const Curve helix = curve_on(tube(), straight_line({1, 0, 0}, {1 + 4 * pi, 1, 0}));
    CHECK(arc_length(helix, 0, 1) == Approx(std::hypot(8 * pi, 3)).epsilon(1e-13));
    CHECK_FALSE(helix.closed);
    CHECK(distance(helix.position(0.5), {2 * std::cos(1.0), 2 * std::sin(1.0), 1.5}) < 1e-14);
    // The seam, twice.
    REQUIRE(helix.breaks.size() == 2);
    CHECK(helix.breaks[0] == Approx((2 * pi - 1) / (4 * pi)).epsilon(1e-14));
}

TEST_CASE("a curve on a surface breaks where it crosses the surface's breaks") {
    const Surface s = sheet();
    const Curve line = line_of_equal_v(s, 0.4, 0.1, 1);
    const auto first = std::upper_bound(s.breaks_u.begin(), s.breaks_u.end(), 0.1);
    CHECK(line.breaks == std::vector<double>(first, s.breaks_u.end()));
    const Curve diagonal = curve_on(s, straight_line({0, 1, 0}, {1, 0, 0}));
    REQUIRE(diagonal.breaks.size() == s.breaks_u.size() + s.breaks_v.size());
    for (const double at : s.breaks_u) {
        const auto beside = std::min_element(
            diagonal.breaks.begin(), diagonal.breaks.end(),
            [&](double a, double b) { return std::abs(a - at) < std::abs(b - at); });
        CHECK(std::abs(*beside - at) < 1e-15);
    }
    // Lengths are then met to rounding, whatever the pieces.
    const double whole = arc_length(diagonal, 0, 1);
    CHECK(arc_length(diagonal, 0, 0.377) + arc_length(diagonal, 0.377, 1) ==
          Approx(whole).epsilon(1e-12));
    CHECK(polyline_length(diagonal, 20000) == Approx(whole).epsilon(1e-7));
}

TEST_CASE("derivatives along curves on surfaces agree with differences") {
    const std::vector<Vec3> points{{0.5, 0.5, 0}, {3, 1.5, 0.5}, {5.5, 4, 0}, {7, 5.5, -0.5}};
    const Surface s = sheet();
    for (const Curve& c : {line_of_equal_u(s, 0.4, 0, 1), line_of_equal_v(s, 0.7, 0.2, 0.9),
                           curve_on(s, straight_line({0.1, 0.9, 0}, {0.8, 0.2, 0})),
                           curve_through(s, points).curve}) {
        const double h = 1e-6 * c.period();
        for (int n = 0; n < 20; ++n) {
            const double t = c.begin + c.period() * (n + 0.37) / 20;
            const Vec3 by_t = (c.position(t + h) - c.position(t - h)) / (2 * h);
            CHECK(distance(by_t, c.derivative(t)) < 1e-7 * norm(by_t));
        }
    }
}

TEST_CASE("a curve through points lies on the surface, through the nearest points of it") {
    const Surface ball = sphere({0, 0, 0}, 1);
    std::vector<Vec3> points;
    for (int n = 0; n <= 12; ++n) {
        const double u = 6 + 0.1 * n;  // across the seam
        const double v = 0.4 * std::sin(3 * u);
        points.push_back((n == 5 ? 1.01 : 1.0) *
                         Vec3{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)});
    }
    const ProjectedCurve made = curve_through(ball, points);
    REQUIRE(made.fault.empty());
    CHECK(made.distance == Approx(0.01).epsilon(1e-10));
    CHECK(made.farthest == 5);
    CHECK_FALSE(made.curve.closed);
    for (int n = 0; n <= 100; ++n) {
        const double t = made.curve.begin + made.curve.period() * n / 100;
        CHECK(std::abs(norm(made.curve.position(t)) - 1) < 1e-15);
    }
    for (const Vec3& p : points) CHECK(project(made.curve, p / norm(p)).distance < 1e-12);
    CHECK(curve_through(ball, {points[0]}).fault == "a curve needs at least two points");
    CHECK(curve_through(ball, {points[0], 2 * points[0]}).fault == "points 1 and 2 coincide");
}

TEST_CASE("a closed curve through points is smooth where it closes, unless a corner is asked") {
    const auto kink = [](const Curve& c) {
        const Vec3 a = c.derivative(c.begin);
        const Vec3 b = c.derivative(c.end);
        return distance(a / norm(a), b / norm(b));
    };
    std::vector<Vec3> loop;    // on one side of a tube
    std::vector<Vec3> around;  // once round it
    for (int n = 0; n <= 16; ++n) {
        const double t = n == 16 ? 0 : 2 * pi * n / 16;
        const double u = 1 + 0.5 * std::sin(t);
        loop.push_back({2 * std::cos(u), 2 * std::sin(u), 1.5 + 0.5 * std::cos(t)});
        around.push_back({2 * std::cos(t + 1), 2 * std::sin(t + 1), 1.5 + 0.5 * std::cos(t)});
    }
    for (const std::vector<Vec3>& points : {loop, around}) {
        const ProjectedCurve smooth = curve_through(tube(), points);
        REQUIRE(smooth.fault.empty());
        CHECK(smooth.curve.closed);
        CHECK(kink(smooth.curve) < 1e-12);
        CHECK(curve_through(tube(), points, true).curve.closed);
        CHECK(kink(curve_through(tube(), points, true).curve) > 1e-4);
        for (const Vec3& p : points) CHECK(project(smooth.curve, p).distance < 1e-12);
    }
}

TEST_CASE("a part of a surface has its points, and is closed when it goes once round") {
    const Surface half = surface_part(tube(), {1.5 * pi, 2.5 * pi}, {0.25, 0.5});
    CHECK_FALSE(half.closed_u);
    CHECK(distance(evaluate(half, {2.25 * pi, 0.4}), evaluate(tube(), {pi / 4, 0.4})) < 1e-14);
    CHECK(half.breaks_u == std::vector<double>{2 * pi});
    CHECK(surface_part(tube(), {1, 1 + 2 * pi}, {0, 1}).closed_u);
    const Surface s = sheet();
    const Surface part = surface_part(s, {0.2, 0.6}, {0, 1});
    for (const double at : part.breaks_u) CHECK((at > 0.2 && at < 0.6));
    CHECK(part.breaks_v == s.breaks_v);
}

TEST_CASE("swapped and reversed surfaces have the same points") {
    const Surface s = sheet();
    const Surface turned = reversed_u(reversed_v(swapped(s)));
    CHECK(turned.breaks_u.size() == s.breaks_v.size());
    for (int n = 0; n < 30; ++n) {
        const double u = n / 29.0;
        const double v = std::fmod(3.3 * u, 1.0);
        CHECK(distance(evaluate(turned, {u, v}), evaluate(s, {1 - v, 1 - u})) < 1e-13);
        CHECK(distance(evaluate(reversed_v(s), {u, 1 - v}), evaluate(s, {u, v})) < 1e-13);
        CHECK(dot(cross(evaluate_derivative_u(swapped(s), {v, u}),
                        evaluate_derivative_v(swapped(s), {v, u})),
                  cross(evaluate_derivative_u(s, {u, v}), evaluate_derivative_v(s, {u, v}))) < 0);
    }
    CHECK(std::is_sorted(turned.breaks_u.begin(), turned.breaks_u.end()));
}

TEST_CASE("a circle extruded is a cylinder, along a circle a surface of translation") {
    const Surface drum = extrusion(circle({1, 1, 0}, 2), straight_line({}, {0, 0, 3}));
    CHECK(drum.closed_u);
    CHECK_FALSE(drum.closed_v);
    for (int n = 0; n < 30; ++n) {
        const Vec3 p = evaluate(drum, {0.3 * n, n / 29.0});
        CHECK(std::hypot(p.x - 1, p.y - 1) == Approx(2).epsilon(1e-15));
        CHECK(p.z == Approx(3 * n / 29.0).margin(1e-15));
    }
    const PlaneAxes upright{{1, 0, 0}, {0, 0, 1}};
    const Surface both = extrusion(circle({0, 0, 0}, 2), circle({5, 0, 0}, 1, upright));
    CHECK(both.closed_v);
    CHECK(distance(evaluate(both, {0, 0}), {2, 0, 0}) < 1e-15);
}
