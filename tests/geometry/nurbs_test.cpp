// SPDX-License-Identifier: Apache-2.0
// Rational B-splines against shapes that they represent exactly.
#include "geometry/nurbs.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/differences.h"

using namespace hexweave;
using std::numbers::pi;

namespace {

const double half_root = std::sqrt(0.5);

/// The quarter of the unit circle from +x to +y.
NurbsPolygon quarter_circle() {
    return {2, {0, 0, 0, 1, 1, 1}, {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {1, half_root, 1}};
}

/// The whole unit circle by nine control points, over knots from 3 to 7.
NurbsPolygon whole_circle() {
    return {2,
            {3, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 7},
            {{1, 0, 0},
             {1, 1, 0},
             {0, 1, 0},
             {-1, 1, 0},
             {-1, 0, 0},
             {-1, -1, 0},
             {0, -1, 0},
             {1, -1, 0},
             {1, 0, 0}},
            {1, half_root, 1, half_root, 1, half_root, 1, half_root, 1}};
}

/// A curve turned by a quarter about z as [Piegl & Tiller 1997, section 8.5] build it: the weights
/// multiply.
NurbsNet quarter_turned(const NurbsPolygon& curve) {
    NurbsNet net;
    net.degree_u = 2;
    net.count_u = 3;
    net.knots_u = {0, 0, 0, 1, 1, 1};
    net.degree_v = curve.degree;
    net.count_v = static_cast<int>(curve.control.size());
    net.knots_v = curve.knots;
    for (std::size_t n = 0; n < curve.control.size(); ++n) {
        const Vec3& p = curve.control[n];
        net.control.insert(net.control.end(), {{p.x, 0, p.z}, {p.x, p.x, p.z}, {0, p.x, p.z}});
        const double w = curve.weights.empty() ? 1 : curve.weights[n];
        net.weights.insert(net.weights.end(), {w, w * half_root, w});
    }
    return net;
}

/// A rough surface of uneven knots, one of them double, and weights.
NurbsNet rough_net() {
    NurbsNet net{
        3, 2, 7, 5, {0, 0, 0, 0, 0.2, 0.2, 0.7, 1, 1, 1, 1}, {-1, -1, -1, 0, 1.5, 2, 2, 2}, {}, {}};
    for (int j = 0; j < net.count_v; ++j) {
        for (int i = 0; i < net.count_u; ++i) {
            net.control.push_back({i + 0.2 * j, 1.5 * j, std::sin(2.0 * i + 3 * j)});
            net.weights.push_back(1 + 0.5 * std::cos(i + 5.0 * j));
        }
    }
    return net;
}

/// The ends of the intervals on which a parameter's derivatives are smooth.
std::vector<double> panels(const std::array<double, 2>& range, const std::vector<double>& breaks) {
    std::vector<double> ends{range[0]};
    ends.insert(ends.end(), breaks.begin(), breaks.end());
    ends.push_back(range[1]);
    return ends;
}

}  // namespace

TEST_CASE("a rational quadratic is a quarter of a circle") {
    REQUIRE(fault_of(quarter_circle()).empty());
    const Curve quarter = nurbs_curve(quarter_circle());
    CHECK_FALSE(quarter.closed);
    CHECK(quarter.breaks.empty());
    CHECK(evaluate(quarter, 0) == Vec3{1, 0, 0});
    CHECK(evaluate(quarter, 1) == Vec3{0, 1, 0});
    for (int n = 0; n <= 100; ++n) {
        const double t = n / 100.0;
        const Vec3 p = evaluate(quarter, t);
        CHECK(std::abs(norm(p) - 1) < 1e-14);
        CHECK(std::abs(dot(p, evaluate_derivative(quarter, t))) < 1e-14);
    }
    // At its begin: degree * weight ratio * leg.
    CHECK(distance(evaluate_derivative(quarter, 0), {0, 2 * half_root, 0}) < 1e-15);
    CHECK(arc_length(quarter, 0, 1) == Approx(pi / 2).epsilon(1e-13));
}

TEST_CASE("a closed rational quadratic is the whole circle, over its own knots") {
    const Curve circle = nurbs_curve(whole_circle());
    CHECK(circle.closed);
    CHECK(circle.begin == 3);
    CHECK(circle.end == 7);
    CHECK(circle.breaks == std::vector<double>{4, 5, 6});
    CHECK(arc_length(circle, 3, 7) == Approx(2 * pi).epsilon(1e-13));
    CHECK(distance(evaluate(circle, 7.5), evaluate(circle, 3.5)) < 1e-15);
    CHECK(distance(evaluate(circle, 5), {-1, 0, 0}) < 1e-15);
}

TEST_CASE("quarters of a cylinder and of a sphere are met to rounding") {
    const Surface cylinder =
        nurbs_surface(quarter_turned({1, {0, 0, 1, 1}, {{2, 0, -1}, {2, 0, 3}}, {}}));
    // The quarter circle in the plane x z, from the equator to the pole.
    NurbsPolygon meridian = quarter_circle();
    for (Vec3& p : meridian.control) p = {p.x, 0, p.y};
    const Surface sphere = nurbs_surface(quarter_turned(meridian));
    for (int j = 0; j <= 40; ++j) {
        for (int i = 0; i <= 40; ++i) {
            const double u = i / 40.0;
            const double v = j / 40.0;
            const Vec3 p = evaluate(cylinder, {u, v});
            CHECK(std::abs(std::hypot(p.x, p.y) - 2) < 1e-14);
            CHECK(std::abs(p.z - (4 * v - 1)) < 1e-14);
            const Vec3 q = evaluate(sphere, {u, v});
            CHECK(std::abs(norm(q) - 1) < 1e-14);
            CHECK(std::abs(dot(q, evaluate_derivative_u(sphere, {u, v}))) < 1e-14);
            CHECK(std::abs(dot(q, evaluate_derivative_v(sphere, {u, v}))) < 1e-14);
        }
    }
    CHECK(norm(evaluate_derivative_u(sphere, {0.3, 1})) < 1e-15);
}

TEST_CASE("a B-spline of one piece is a Bezier polynomial, of the greatest degree too") {
    // Control points at k / p on a line run evenly whatever the degree; squared they give a
    // parabola less the variance of the binomial distribution.
    for (const int p : {1, 2, 7, greatest_nurbs_degree}) {
        NurbsPolygon polygon;
        polygon.degree = p;
        const auto count = static_cast<std::size_t>(p) + 1;
        polygon.knots.assign(count, -1.0);
        polygon.knots.insert(polygon.knots.end(), count, 1.0);
        for (int k = 0; k <= p; ++k) {
            const double x = static_cast<double>(k) / p;
            polygon.control.push_back({x, x * x, 0});
        }
        REQUIRE(fault_of(polygon).empty());
        const Curve curve = nurbs_curve(polygon);
        for (int n = 0; n <= 20; ++n) {
            const double t = -1 + n / 10.0;
            const double x = (t + 1) / 2;
            const Vec3 exact{x, x * x + x * (1 - x) / p, 0};
            CHECK(distance(evaluate(curve, t), exact) < 4e-15);
            const Vec3 slope{0.5, x + (1 - 2 * x) / (2 * p), 0};
            CHECK(distance(evaluate_derivative(curve, t), slope) < 4e-14);
        }
    }
}

TEST_CASE("the shape does not depend on where knots are inserted") {
    // Boehm's insertion of 0.5 into a cubic Bezier curve: midpoints of midpoints.
    const std::vector<Vec3> b{{0, 0, 0}, {1, 3, 1}, {2, -1, 4}, {5, 0, 0}};
    const Curve before = nurbs_curve({3, {0, 0, 0, 0, 1, 1, 1, 1}, b, {}});
    const std::vector<Vec3> more{b[0], lerp(b[0], b[1], 0.5), lerp(b[1], b[2], 0.5),
                                 lerp(b[2], b[3], 0.5), b[3]};
    const Curve after = nurbs_curve({3, {0, 0, 0, 0, 0.5, 1, 1, 1, 1}, more, {}});
    for (int n = 0; n <= 50; ++n) {
        CHECK(distance(evaluate(before, n / 50.0), evaluate(after, n / 50.0)) < 1e-14);
    }
}

TEST_CASE("derivatives of a rational surface agree with differences of high order") {
    const NurbsNet net = rough_net();
    REQUIRE(fault_of(net).empty());
    const Surface s = nurbs_surface(net);
    CHECK(s.breaks_u == std::vector<double>{0.2, 0.7});
    CHECK(s.range_v == std::array<double, 2>{-1, 2});
    const std::vector<double> us = panels(s.range_u, s.breaks_u);
    const std::vector<double> vs = panels(s.range_v, s.breaks_v);
    double worst = 0;
    for (std::size_t b = 0; b + 1 < vs.size(); ++b) {
        for (std::size_t a = 0; a + 1 < us.size(); ++a) {
            const Differences along_u(us[a], us[a + 1]);
            const Differences along_v(vs[b], vs[b + 1]);
            for (int n = 0; n < 25; ++n) {
                const double u = us[a] + (us[a + 1] - us[a]) * (n % 5) / 5;
                const double v = vs[b] + (vs[b + 1] - vs[b]) * n / 25;
                const Vec3 by_u = along_u([&](double t) { return s.position(t, v); }, u);
                const Vec3 by_v = along_v([&](double t) { return s.position(u, t); }, v);
                worst = std::max(worst, distance(by_u, s.derivative_u(u, v)) / norm(by_u));
                worst = std::max(worst, distance(by_v, s.derivative_v(u, v)) / norm(by_v));
            }
        }
    }
    CHECK(worst < 1e-8);
}

TEST_CASE("a surface whose ends coincide is closed along that parameter only") {
    NurbsNet tube;
    const NurbsPolygon circle = whole_circle();
    tube.degree_u = circle.degree;
    tube.count_u = 9;
    tube.knots_u = circle.knots;
    tube.count_v = 2;
    tube.knots_v = {0, 0, 1, 1};
    for (const double z : {0.0, 2.0}) {
        for (const Vec3& p : circle.control) tube.control.push_back(p + Vec3{0, 0, z});
        tube.weights.insert(tube.weights.end(), circle.weights.begin(), circle.weights.end());
    }
    REQUIRE(fault_of(tube).empty());
    const Surface surface = nurbs_surface(tube);
    CHECK(surface.closed_u);
    CHECK_FALSE(surface.closed_v);
    CHECK(distance(evaluate(surface, {7.25, 0.5}), evaluate(surface, {3.25, 0.5})) < 1e-15);
}

TEST_CASE("what is wrong with control points, knots and weights is said") {
    const auto with = [](auto change) {
        NurbsPolygon polygon = quarter_circle();
        change(polygon);
        return fault_of(polygon);
    };
    CHECK(with([](NurbsPolygon& p) { p.knots.pop_back(); }) ==
          "degree 2 and 3 control points need 6 knots, not 5");
    CHECK(with([](NurbsPolygon& p) { p.knots[2] = 2; }) ==
          "the knots must ascend, not go from 2 to 1");
    CHECK(with([](NurbsPolygon& p) { p.knots = {0, 0, 0, 0, 0, 0}; }) == "the knots span no range");
    CHECK(with([](NurbsPolygon& p) { p.knots[5] = NAN; }) == "a knot is infinite");
    CHECK(with([](NurbsPolygon& p) { p.weights[1] = -0.5; }) ==
          "a weight must be positive, not -0.5");
    CHECK(with([](NurbsPolygon& p) { p.weights.pop_back(); }) ==
          "there are 2 weights for 3 control points");
    CHECK(with([](NurbsPolygon& p) { p.degree = 3; }) ==
          "degree 3 needs at least 4 control points, not 3");
    CHECK(with([](NurbsPolygon& p) { p.degree = 26; }) ==
          "a degree must be between 1 and 25, not 26");
    CHECK(with([](NurbsPolygon& p) { p.control[1].z = INFINITY; }) ==
          "a control point is infinite");
    NurbsNet net = rough_net();
    net.control.pop_back();
    CHECK(fault_of(net) == "there are 34 control points, not 7 times 5");
    net = rough_net();
    net.knots_v.push_back(3);
    CHECK(fault_of(net) == "along v: degree 2 and 5 control points need 8 knots, not 9");
    CHECK(fault_of(NurbsPolygon{1, {0, 0, 0.5, 0.5, 1, 1}, std::vector<Vec3>(4), {}}) ==
          "the knot 0.5 stands 2 times, which tears a degree of 1");
}
