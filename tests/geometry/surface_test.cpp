// SPDX-License-Identifier: Apache-2.0
#include "geometry/surface.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "geometry/conics.h"
#include "geometry/lines.h"
#include "geometry/surface_parts.h"
#include "geometry/surface_projection.h"

using namespace hexweave;
using std::numbers::pi;

namespace {

/// The upper side of a swept wing whose rounded tip shrinks to a line (v = 1), and which rises
/// steeply from both its leading and its tip edge.
Vec3 rounded_wing(double u, double v) {
    const double r = 1 - u;
    const double x = r * r;
    const double thickness =
        0.6 * (0.2969 * r + x * (-0.1260 + x * (-0.3516 + x * (0.2843 - 0.1036 * x))));
    const double half = std::sin(pi / 4 * (1 - v));
    const double d = std::min(1.0, 20 * half * half);
    const double y = 1.5 * (1 - 2 * half * half);
    const double chord = 1 - 0.44 * y / 1.5;
    return {0.577 * y + chord * x, -y, chord * thickness * std::sqrt(d * (2 - d))};
}

/// A cone that shrinks to its apex (v = 1).
Surface pointed_cone() {
    return cone({0, 0, 0}, {0, 0, 2}, 1, 0);
}

std::vector<std::pair<std::string, Surface>> families() {
    return {
        {"formula", formula_surface(
                        [](double u, double v) {
                            return Vec3{u, v * v, std::sin(3 * u * v)};
                        },
                        {-1, 1}, {0.5, 2})},
        {"plane", plane_surface({1, 2, 3}, {2, 0, 1}, {0.5, 1, 0})},
        {"sphere", sphere({1, 2, 3}, 4, {1, 1, 0.5})},
        {"cylinder", cone({0, 1, 0}, {1, 2, 5}, 2, 2)},
        {"cone", pointed_cone()},
        {"ruled", ruled_surface(circle({0, 0, 0}, 1), circle({1, 0, 2}, 2))},
        {"revolution", revolution(straight_line({1, 0, 0}, {2, 0, 1}), {0, 0, 0}, {0, 0, 1}, 3)},
        {"moved sphere", transformed(sphere({0, 0, 0}, 1), rotation({1, 2, 3}, 1, {4, 5, 6}))},
        {"part", surface_part(sphere({1, 2, 3}, 4), {5, 7}, {-1, 1})},
        {"swapped cone", swapped(pointed_cone())},
        {"reversed cone", reversed_u(pointed_cone())},
        {"other way reversed cone", reversed_v(pointed_cone())},
        {"extrusion",
         extrusion(circle({0, 0, 0}, 1), arc({0, 0, 3}, 2, 0, 2, {{1, 0, 0}, {0, 0, 1}}))},
        {"rounded wing", formula_surface(rounded_wing, {0, 1}, {0, 1})},
    };
}

SurfaceParameters at_shares(const Surface& s, double f, double g) {
    return {s.range_u[0] + f * (s.range_u[1] - s.range_u[0]),
            s.range_v[0] + g * (s.range_v[1] - s.range_v[0])};
}

}  // namespace

TEST_CASE("derivatives of surfaces agree with differences of their positions") {
    constexpr int samples = 11;
    for (const auto& [name, s] : families()) {
        INFO(name);
        const double du = 1e-6 * (s.range_u[1] - s.range_u[0]);
        const double dv = 1e-6 * (s.range_v[1] - s.range_v[0]);
        double worst = 0;
        for (int j = 0; j < samples; ++j) {
            for (int i = 0; i < samples; ++i) {
                const auto [u, v] = at_shares(s, (i + 0.5) / samples, (j + 0.5) / samples);
                const Vec3 by_u = (s.position(u + du, v) - s.position(u - du, v)) / (2 * du);
                const Vec3 by_v = (s.position(u, v + dv) - s.position(u, v - dv)) / (2 * dv);
                worst = std::max(worst, distance(by_u, s.derivative_u(u, v)) / (1 + norm(by_u)));
                worst = std::max(worst, distance(by_v, s.derivative_v(u, v)) / (1 + norm(by_v)));
            }
        }
        CHECK(worst < 1e-7);
    }
}

TEST_CASE("points of spheres, cylinders and cones have their distances from centre and axis") {
    for (int n = 0; n < 50; ++n) {
        const double f = n / 49.0;
        const double g = std::fmod(7.3 * f, 1.0);
        const Surface ball = sphere({1, 2, 3}, 4, {1, 1, 0.5});
        CHECK(distance(evaluate(ball, at_shares(ball, f, g)), {1, 2, 3}) ==
              Approx(4).epsilon(1e-15));
        const Surface point = pointed_cone();
        const Vec3 p = evaluate(point, at_shares(point, f, g));
        CHECK(std::hypot(p.x, p.y) == Approx(1 - p.z / 2).margin(1e-15));
    }
    const Surface ball = sphere({0, 0, 0}, 1, {0, 1, -1});
    CHECK(distance(evaluate(ball, {0.3, pi / 2}), Vec3{0, 1, -1} / std::sqrt(2.0)) < 1e-15);
}

TEST_CASE("surfaces know along which parameter they are closed") {
    const Surface ball = formula_surface(
        [](double u, double v) {
            return Vec3{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
        },
        {0, 2 * pi}, {-pi / 2, pi / 2});
    CHECK(ball.closed_u);
    CHECK_FALSE(ball.closed_v);
    CHECK_FALSE(formula_surface(rounded_wing, {0, 1}, {0, 1}).closed_u);
    CHECK(distance(evaluate(ball, {2 * pi + 0.3, 0.1}), evaluate(ball, {0.3, 0.1})) < 1e-15);
    CHECK(ruled_surface(circle({0, 0, 0}, 1), circle({0, 0, 1}, 1)).closed_u);
    const Curve half = arc({0, 0, 0}, 1, -pi / 2, pi / 2);
    CHECK(revolution(half, {0, 0, 0}, {0, 1, 0}, 2 * pi).closed_u);
    CHECK_FALSE(revolution(half, {0, 0, 0}, {0, 1, 0}, 3).closed_u);
}

TEST_CASE("a curve revolved is a circle about the axis everywhere") {
    const Surface ball =
        revolution(arc({0, 0, 0}, 2, -pi / 2, pi / 2), {0, 0, 0}, {0, 1, 0}, 2 * pi);
    const Vec3 p = evaluate(ball, {pi / 2, 0.5});
    const Vec3 start = evaluate(ball, {0, 0.5});
    CHECK(norm(p) == Approx(2).epsilon(1e-15));
    CHECK(p.y == Approx(start.y).margin(1e-15));
    CHECK(p.z == Approx(-start.x).margin(1e-15));  // right-handed about y: from x towards -z
}

TEST_CASE("projection gives back every point of a surface, at degenerate edges too") {
    constexpr int samples = 23;
    for (const auto& [name, s] : families()) {
        INFO(name);
        const SurfaceProjection projection(s);
        double worst = 0;
        for (int j = 0; j <= samples; ++j) {
            for (int i = 0; i <= samples; ++i) {
                const Vec3 p = evaluate(s, at_shares(s, i / double{samples}, j / double{samples}));
                const SurfacePoint found = projection.nearest(p);
                worst = std::max(worst, distance(p, found.position));
                worst = std::max(worst, distance(evaluate(s, found.parameters), found.position));
            }
        }
        CHECK(worst < 1e-11 * projection.size());
    }
}

TEST_CASE("projection is accurate a hair away from an edge that shrinks to a line") {
    const Surface s = formula_surface(rounded_wing, {0, 1}, {0, 1});
    const SurfaceProjection projection(s);
    for (const double off : {1e-3, 1e-5, 1e-7, 1e-9}) {
        for (const double u : {0.0, 1e-8, 0.3, 1 - 1e-4, 1 - 1e-8, 1.0}) {
            INFO(off << ' ' << u);
            const Vec3 p = evaluate(s, {u, 1 - off});
            CHECK(distance(projection.nearest(p).position, p) < 1e-11);
        }
    }
}

TEST_CASE("a point off a surface is projected along the normal") {
    const SurfaceProjection ball(sphere({0, 0, 0}, 2));
    const SurfacePoint found = ball.nearest({3, 0.3, 0.4});
    CHECK(found.distance == Approx(norm(Vec3{3, 0.3, 0.4}) - 2).epsilon(1e-12));
    CHECK(distance(found.position, 2 * Vec3{3, 0.3, 0.4} / norm(Vec3{3, 0.3, 0.4})) < 1e-7);
    const SurfaceProjection flat(plane_surface({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    CHECK(flat.nearest({0.3, 0.4, 5}).distance == Approx(5));
    CHECK(distance(flat.nearest({2, 0.4, 0}).position, {1, 0.4, 0}) < 1e-14);  // its edge
}

TEST_CASE("parameters along a line are continued across a seam") {
    const Surface tube = cone({0, 0, 0}, {0, 0, 1}, 1, 1);
    const SurfaceProjection projection(tube);
    std::vector<Vec3> line;
    for (int n = 0; n <= 40; ++n) {
        const double angle = 1 + 2 * pi * n / 40;
        line.push_back({std::cos(angle), std::sin(angle), 0.5});
    }
    const std::vector<SurfacePoint> found = projection.along(line);
    for (std::size_t n = 0; n < found.size(); ++n) {
        CHECK(found[n].distance < 1e-14);
        CHECK(found[n].parameters.u - found[0].parameters.u ==
              Approx(2 * pi * static_cast<double>(n) / 40).margin(1e-12));
    }
}
