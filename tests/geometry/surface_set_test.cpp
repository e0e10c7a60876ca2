// SPDX-License-Identifier: Apache-2.0
// Nearest points and parameters: on one surface to the last digits, and on several as on one.
#include "geometry/surface_set.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "geometry/conics.h"
#include "geometry/curve_on_surface.h"
#include "geometry/lines.h"

using namespace hexweave;
using std::numbers::pi;

namespace {

std::shared_ptr<const Surface> shared(Surface surface) {
    return std::make_shared<const Surface>(std::move(surface));
}

/// The part of the unit sphere with u from `from` to `to`, v from the south to the north pole.
Surface gore(double from, double to) {
    return formula_surface(
        [](double u, double v) {
            return Vec3{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
        },
        {from, to}, {-pi / 2, pi / 2});
}

Vec3 on_ball(double longitude, double latitude) {
    return {std::cos(longitude) * std::cos(latitude), std::sin(longitude) * std::cos(latitude),
            std::sin(latitude)};
}

/// Two halves of a ball that meet at y = 0, the second turned and parametrized otherwise.
SurfaceSet two_halves() {
    const Surface other = formula_surface(
        [](double u, double v) { return on_ball(pi + pi * (u + 0.1 * u * (1 - u)), v); }, {0, 1},
        {-pi / 2, pi / 2});
    return SurfaceSet({shared(gore(0, pi)), shared(other)});
}

}  // namespace

TEST_CASE("parameters are got back to rounding, on both sides of a seam and beside a pole") {
    const Surface ball = sphere({0, 0, 0}, 1);
    const SurfaceProjection projection(ball);
    for (const double v : {-1.5707, -1.2, -1e-9, 0.0, 0.3, 1.5, pi / 2 - 1e-3}) {
        for (const double u : {0.0, 1e-12, 1e-6, 1.0, pi, 5.0, 2 * pi - 1e-6, 2 * pi - 1e-12}) {
            const SurfacePoint found = projection.nearest(evaluate(ball, {u, v}));
            const double turn = std::remainder(found.parameters.u - u, 2 * pi);
            CHECK(std::abs(turn) * std::cos(v) < 1e-12);
            CHECK(std::abs(found.parameters.v - v) < 1e-12);
        }
    }
}

TEST_CASE("the foot of a point off a surface is accurate to rounding") {
    const SurfaceProjection ball(sphere({0, 0, 0}, 2));
    for (const double height : {1e-6, 1e-3, 0.1, 1.0}) {
        for (const double u : {0.1, 2.0, 6.2}) {
            const Vec3 foot = 2 * on_ball(u, 0.4);
            CHECK(distance(ball.nearest((1 + height / 2) * foot).position, foot) < 1e-13);
            CHECK(distance(ball.nearest((1 - height / 3) * foot).position, foot) < 1e-13);
        }
    }
}

TEST_CASE("two halves of a ball give back every point, on the seam and at the poles too") {
    const SurfaceSet halves = two_halves();
    CHECK(halves.size() == Approx(std::sqrt(12.0)).epsilon(0.01));
    for (int j = 0; j <= 24; ++j) {
        for (int i = 0; i <= 48; ++i) {
            const Vec3 p = on_ball(2 * pi * i / 48, -pi / 2 + pi * j / 24);
            const PatchPoint found = halves.nearest(p);
            CHECK(found.point.distance < 1e-12);
            CHECK(distance(evaluate(halves.surface(found.patch), found.point.parameters), p) <
                  1e-12);
            if (std::abs(p.y) > 1e-9) CHECK(found.patch == (p.y > 0 ? 0 : 1));
        }
    }
}

TEST_CASE("a search walks over the border of a surface to the next") {
    const SurfaceSet halves = two_halves();
    PatchPoint at = halves.nearest(on_ball(0.05, 0.2));
    REQUIRE(at.patch == 0);
    at = halves.nearest_from(on_ball(-0.05, 0.2), {at});
    CHECK(at.patch == 1);
    CHECK(at.point.distance < 1e-12);
    std::vector<Vec3> line;
    for (int n = 0; n <= 60; ++n) line.push_back(on_ball(1 + 2 * pi * n / 60, 0.3));
    for (const PatchPoint& p : halves.along(line)) CHECK(p.point.distance < 1e-12);
}

TEST_CASE("of surfaces that share a border the first named has it") {
    const SurfaceSet halves = two_halves();
    for (const double v : {-1.0, 0.0, 0.7}) {
        CHECK(halves.nearest(on_ball(0, v)).patch == 0);
        CHECK(halves.nearest(on_ball(pi, v)).patch == 0);
        CHECK(halves.nearest(on_ball(pi, v) + Vec3{0, -1e-11, 0}).patch == 0);
    }
}

TEST_CASE("the image of a line of parameters runs as its surface does, across a seam too") {
    const Surface ball = sphere({0, 0, 0}, 1);
    const Curve line = parameter_line(ball, {6, 0.2}, {7, 0.2});
    for (const double t : {0.0, 0.2, 0.5, 1.0}) {
        CHECK(distance(evaluate(line, t), on_ball(6 + t, 0.2)) < 1e-15);
    }
    CHECK(arc_length(line, 0, 1) == Approx(std::cos(0.2)).epsilon(1e-13));
}

TEST_CASE("a straight line put onto a ball is a great circle, over several patches too") {
    const Vec3 a = on_ball(-0.6, 0.1);
    const Vec3 b = on_ball(0.7, 0.5);
    const Vec3 normal = cross(a, b) / norm(cross(a, b));
    for (const bool whole : {true, false}) {
        const SurfaceSet set = whole ? SurfaceSet({shared(sphere({0, 0, 0}, 1))}) : two_halves();
        const Curve great = projected_curve(straight_line(a, b), set);
        CHECK(distance(evaluate(great, 0), a) < 1e-13);
        CHECK(distance(evaluate(great, 1), b) < 1e-13);
        for (int n = 0; n <= 100; ++n) {
            const Vec3 p = evaluate(great, n / 100.0);
            CHECK(std::abs(norm(p) - 1) < 1e-14);
            CHECK(std::abs(dot(p, normal)) < 2e-9);
            const Vec3 ahead = evaluate_derivative(great, n / 100.0);
            CHECK(std::abs(dot(ahead, normal)) < 1e-6);
        }
        CHECK(arc_length(great, 0, 1) == Approx(std::acos(dot(a, b))).epsilon(1e-9));
        CHECK((great.breaks.size() > 0) == true);
    }
}

TEST_CASE("a curve on a surface stays where it is when it is put onto it") {
    const SurfaceSet set({shared(sphere({0, 0, 0}, 1))});
    const Curve ring = circle({0, 0, 0.6}, 0.8);
    const Curve put = projected_curve(ring, set);
    CHECK(put.closed);
    for (int n = 0; n <= 40; ++n) {
        const double t = ring.begin + ring.period() * n / 40;
        CHECK(distance(evaluate(put, t), evaluate(ring, t)) < 1e-12);
        CHECK(distance(evaluate_derivative(put, t), evaluate_derivative(ring, t)) < 1e-9);
    }
}

TEST_CASE("points of a border are found along it, however its lines of parameters slant") {
    const Surface slanting = formula_surface(
        [](double u, double v) {
            return Vec3{u + 0.9 * v, u * u / 4, v + std::sin(3 * v) / 4};
        },
        {0, 1}, {0, 1});
    const SurfaceProjection projection(slanting);
    std::vector<Vec3> line;
    for (int n = 0; n <= 50; ++n) line.push_back(evaluate(slanting, {0, n / 50.0}));
    for (const SurfacePoint& p : projection.along(line)) CHECK(p.distance < 1e-14);
    for (const Vec3& p : line) {
        // Beyond the border the nearest point is on it.
        const SurfacePoint beyond = projection.nearest(p - Vec3{1e-3, 0, 0});
        const Vec3 along = evaluate_derivative_v(slanting, beyond.parameters);
        CHECK(beyond.parameters.u == 0);
        if (beyond.parameters.v > 0 && beyond.parameters.v < 1) {
            CHECK(std::abs(dot(p - Vec3{1e-3, 0, 0} - beyond.position, along)) < 1e-14);
        }
    }
}
