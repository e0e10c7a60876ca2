// SPDX-License-Identifier: Apache-2.0
#include "geometry/conics.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "geometry/curve_checks.h"
#include "geometry/lines.h"

using namespace hexweave;

namespace {
constexpr double pi = std::numbers::pi;
}

TEST_CASE("a straight line starts and ends at its points") {
    const Vec3 a{0.1, 0.2, 0.3};
    const Vec3 b{1.7, -2.3, 0.9};
    const Curve line = straight_line(a, b);
    CHECK(evaluate(line, 0) == a);
    CHECK(evaluate(line, 1) == b);
    CHECK(derivative_error(line) < 1e-9);
    CHECK(arc_length(line, 0, 1) == Approx(distance(a, b)).epsilon(1e-15));
}

TEST_CASE("a polyline passes its points at its breaks, with unit speed") {
    const std::vector<Vec3> points{{0, 0, 0}, {3, 4, 0}, {3, 4, 2}, {1, 1, 1}};
    const Curve chain = polyline(points).curve.value();
    CHECK_FALSE(chain.closed);
    CHECK(chain.breaks == std::vector<double>{5, 7});
    CHECK(evaluate(chain, 0) == points[0]);
    CHECK(evaluate(chain, 5) == points[1]);
    CHECK(evaluate(chain, 7) == points[2]);
    CHECK(evaluate(chain, chain.end) == points[3]);
    CHECK(norm(evaluate_derivative(chain, 6)) == Approx(1).epsilon(1e-15));
    CHECK(evaluate_derivative(chain, 5) == Vec3{0, 0, 1});
    CHECK(derivative_error(chain) < 1e-9);
}

TEST_CASE("a polyline that comes back is closed; one with coincident points is refused") {
    CHECK(polyline({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}).curve.value().closed);
    CHECK(polyline({{0, 0, 0}}).error == "a polyline needs at least two points");
    CHECK(polyline({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}).error == "points 2 and 3 coincide");
    CHECK(polyline({{5, 5, 5}, {5, 5, 5}}).error == "points 1 and 2 coincide");
}

TEST_CASE("a circle starts at +x, runs counter-clockwise and closes to the bit") {
    const Curve round = circle({1, 2, 3}, 2);
    CHECK(round.closed);
    CHECK(evaluate(round, round.begin) == Vec3{3, 2, 3});
    CHECK(evaluate(round, round.end) == Vec3{3, 2, 3});
    CHECK(evaluate(round, 1) == Vec3{1, 4, 3});
    CHECK(evaluate(round, 2) == Vec3{-1, 2, 3});
    CHECK(evaluate(round, 3) == Vec3{1, 0, 3});
    CHECK(derivative_error(round) < 1e-8);
    CHECK(circle({}, 1).position(0.7).z == 0);
}

TEST_CASE("a circle in a plane of its own is perpendicular to the normal") {
    const Vec3 normal{1, 2, -2};
    const PlaneAxes axes = plane_axes(normal).value();
    const Curve round = circle({1, 0, 0}, 2, axes);
    for (const double t : {0.0, 0.4, 1.7, 3.9}) {
        const Vec3 arm = evaluate(round, t) - Vec3{1, 0, 0};
        CHECK(norm(arm) == Approx(2).epsilon(1e-15));
        CHECK(dot(arm, normal) == Approx(0).margin(1e-14));
        CHECK(dot(cross(arm, evaluate_derivative(round, t)), normal) > 0);
    }
}

TEST_CASE("plane axes follow the axis that is given, else x, else y") {
    CHECK(plane_axes({0, 0, 5}).value().x == Vec3{1, 0, 0});
    CHECK(plane_axes({0, 0, 5}).value().y == Vec3{0, 1, 0});
    CHECK(plane_axes({2, 0, 0}).value().x == Vec3{0, 1, 0});
    CHECK(plane_axes({2, 0, 0}).value().y == Vec3{0, 0, 1});
    CHECK(plane_axes({0, 1, 0}, Vec3{0, 3, 1}).value().x == Vec3{0, 0, 1});
    CHECK_FALSE(plane_axes({0, 0, 0}));
    CHECK_FALSE(plane_axes({0, 0, 1}, Vec3{0, 0, -2}));
}

TEST_CASE("an arc runs from angle to angle, either way") {
    const Curve quarter = arc({}, 2, 0, pi / 2);
    CHECK(distance(evaluate(quarter, quarter.begin), {2, 0, 0}) < 1e-15);
    CHECK(distance(evaluate(quarter, quarter.end), {0, 2, 0}) < 1e-15);
    CHECK(arc_length(quarter, quarter.begin, quarter.end) == Approx(pi).epsilon(1e-14));
    const Curve back = arc({}, 2, pi / 2, 0);
    CHECK(distance(evaluate(back, back.begin), {0, 2, 0}) < 1e-15);
    CHECK(distance(evaluate(back, back.end), {2, 0, 0}) < 1e-15);
    CHECK(derivative_error(back) < 1e-8);
}

TEST_CASE("an arc through three points takes the way past the middle one") {
    const Vec3 a{1, 0, 0};
    const Vec3 b{0, 1, 0};
    const Curve shorter = arc_through(a, {std::sqrt(0.5), std::sqrt(0.5), 0}, b).curve.value();
    CHECK(arc_length(shorter, shorter.begin, shorter.end) == Approx(pi / 2).epsilon(1e-14));
    const Curve longer = arc_through(a, {0, -1, 0}, b).curve.value();
    CHECK(arc_length(longer, longer.begin, longer.end) == Approx(3 * pi / 2).epsilon(1e-14));
    for (const Curve& curve : {shorter, longer}) {
        CHECK(distance(evaluate(curve, curve.begin), a) < 1e-15);
        CHECK(distance(evaluate(curve, curve.end), b) < 1e-15);
        CHECK(evaluate(curve, 0.3).z == 0);
    }
    const Vec3 p{1, 2, 3};
    const Vec3 q{2, 0, 4};
    const Vec3 r{0, -1, 1};
    const Curve space = arc_through(p, q, r).curve.value();
    CHECK(project(space, q).distance < 1e-14);
    CHECK(distance(evaluate(space, space.end), r) < 1e-14);
}

TEST_CASE("three points that make no circle are refused") {
    CHECK(arc_through({0, 0, 0}, {1, 1, 0}, {2, 2, 0}).error ==
          "the three points of the arc lie on a straight line");
    CHECK(arc_through({0, 0, 0}, {1, 1, 0}, {0, 0, 0}).error == "the two ends of the arc coincide");
    CHECK(arc_through({0, 0, 0}, {0, 0, 0}, {2, 2, 0}).error ==
          "the first two points of the arc coincide");
    CHECK(arc_through({0, 0, 0}, {2, 2, 0}, {2, 2, 0}).error ==
          "the last two points of the arc coincide");
}

TEST_CASE("an ellipse has its half-axes where they are turned to") {
    const Curve turned = ellipse({1, 1, 0}, 3, 1, pi / 6);
    const Vec3 end{1 + 3 * std::cos(pi / 6), 1 + 3 * std::sin(pi / 6), 0};
    CHECK(distance(evaluate(turned, 0), end) < 1e-14);
    CHECK(distance(evaluate(turned, 1), Vec3{1, 1, 0}) == Approx(1).epsilon(1e-15));
    CHECK(evaluate(turned, 0) == evaluate(turned, 4));
    CHECK(derivative_error(turned) < 1e-8);
    CHECK(evaluate(ellipse({}, 2, 1, pi / 2), 0) == Vec3{0, 2, 0});
}
