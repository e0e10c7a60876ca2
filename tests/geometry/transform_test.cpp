// SPDX-License-Identifier: Apache-2.0
#include "geometry/transform.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "geometry/conics.h"
#include "geometry/curve_checks.h"
#include "geometry/formula.h"
#include "geometry/lines.h"
#include "geometry/naca.h"

using namespace hexweave;

namespace {

constexpr double pi = std::numbers::pi;

bool near(const Vec3& a, const Vec3& b) {
    return distance(a, b) < 1e-14;
}

}  // namespace

TEST_CASE("affine maps move points where they say") {
    CHECK(apply(translation({1, 2, 3}), {1, 1, 1}) == Vec3{2, 3, 4});
    CHECK(apply(scaling({2, 3, 4}, {1, 1, 1}), {2, 2, 2}) == Vec3{3, 4, 5});
    CHECK(near(apply(rotation({0, 0, 2}, pi / 2), {1, 0, 0}), {0, 1, 0}));
    CHECK(near(apply(rotation({1, 0, 0}, pi / 2, {0, 1, 0}), {5, 2, 0}), {5, 1, 1}));
    CHECK(near(apply(rotation({1, 1, 1}, 2 * pi / 3), {1, 0, 0}), {0, 1, 0}));
    CHECK(near(apply(reflection({0, 1, 0}, {0, 3, 0}), {4, 3, 5}), {4, -1, 5}));
    CHECK(near(apply(reflection({}, {1, -1, 0}), {2, 7, 1}), {7, 2, 1}));
}

TEST_CASE("a quarter turn about a coordinate axis exchanges coordinates to the last bit") {
    const Vec3 p{0.1, 0.7, -0.3};
    CHECK(apply(rotation({0, 0, 1}, pi / 2), p) == Vec3{-0.7, 0.1, -0.3});
    CHECK(apply(rotation({3, 0, 0}, -pi / 2), p) == Vec3{0.1, -0.3, -0.7});
    CHECK(apply(rotation({0, 1, 0}, 3 * pi / 2), p) == Vec3{0.3, 0.7, 0.1});
    CHECK(apply(rotation({0, 0, 1}, -7 * pi), p) == Vec3{-0.1, -0.7, -0.3});
    // A little more is a little more, not a quarter.
    CHECK(apply(rotation({0, 0, 1}, pi / 2 + 1e-12), p) != Vec3{-0.7, 0.1, -0.3});
}

TEST_CASE("maps compose in the order they are written") {
    const Affine both = compose(rotation({0, 0, 1}, pi / 2), translation({1, 0, 0}));
    CHECK(near(apply(both, {1, 0, 0}), {1, 1, 0}));
    const Affine other = compose(translation({1, 0, 0}), rotation({0, 0, 1}, pi / 2));
    CHECK(near(apply(other, {1, 0, 0}), {0, 2, 0}));
}

TEST_CASE("a transformed curve is the image of the curve") {
    const Curve curve = circle({}, 1);
    const Curve image = transformed(curve, scaling({3, 2, 1}));
    CHECK(greatest_distance(image, ellipse({}, 3, 2)) < 1e-14);
    CHECK(image.closed);
    CHECK(derivative_error(transformed(image, rotation({1, 2, 3}, 0.7, {1, 0, 0}))) < 1e-8);
    const Curve planar = transformed(curve, compose(rotation({0, 0, 1}, 0.3), scaling({2, 2, 2})));
    CHECK(evaluate(planar, 0.7).z == 0);
}

TEST_CASE("a reversed curve is the curve backwards") {
    const Curve curve =
        naca_airfoil("2412", 1, AirfoilSide::whole, TrailingEdge::sharp).curve.value();
    const Curve back = reversed(curve);
    CHECK(evaluate(back, back.begin) == evaluate(curve, curve.end));
    CHECK(evaluate(back, -0.3) == evaluate(curve, 0.3));
    CHECK(derivative_error(back) < 1e-7);
    CHECK(back.closed);
    CHECK(back.breaks.size() == curve.breaks.size());
    CHECK(back.breaks.front() == -curve.breaks.back());
    CHECK(greatest_distance(reversed(back), curve) == 0);
}

TEST_CASE("a piece keeps its parameters, and the breaks inside") {
    const Curve chain =
        polyline({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}}).curve.value();
    const Curve part = piece(chain, 0.5, 2.5);
    CHECK(part.begin == 0.5);
    CHECK(part.end == 2.5);
    CHECK(part.breaks == std::vector<double>{1, 2});
    CHECK_FALSE(part.closed);
    CHECK(evaluate(part, 1.5) == Vec3{1, 0.5, 0});
    const Curve over_seam = piece(chain, 3.5, 5.5);
    CHECK(over_seam.breaks == std::vector<double>{4, 5});
    CHECK(evaluate(over_seam, 5.5) == Vec3{1, 0.5, 0});
    const Curve back = piece(chain, 2.5, 0.5);
    CHECK(evaluate(back, back.begin) == evaluate(chain, 2.5));
    CHECK(evaluate(back, back.end) == evaluate(chain, 0.5));
}

TEST_CASE("a piece by fractions holds that part of the length") {
    const Curve side =
        naca_airfoil("0012", 1, AirfoilSide::upper, TrailingEdge::sharp).curve.value();
    const double length = arc_length(side, 0, 1);
    const Curve part = piece_by_fractions(side, 0.25, 0.75);
    CHECK(arc_length(part, part.begin, part.end) == Approx(0.5 * length).epsilon(1e-12));
    const Curve back = piece_by_fractions(side, 1, 0);
    CHECK(evaluate(back, back.begin) == evaluate(side, side.end));
    const Curve over_seam = piece_by_fractions(circle({}, 1), 0.75, 1.25);
    CHECK(near(evaluate(over_seam, over_seam.begin), {0, -1, 0}));
    CHECK(near(evaluate(over_seam, over_seam.end), {0, 1, 0}));
    CHECK(arc_length(over_seam, over_seam.begin, over_seam.end) == Approx(pi).epsilon(1e-13));
    const Curve all = piece_by_fractions(circle({}, 1), 0, 1);
    CHECK(all.closed);
}

TEST_CASE("a formula's derivative is accurate over the range and never leaves it") {
    const auto wave = [](double t) {
        if (t < 0 || t > 2) return Vec3{1e9, 1e9, 1e9};
        return Vec3{std::cos(9 * t), std::exp(t), t * t * t};
    };
    const Curve curve = formula(wave, 0, 2);
    for (int k = 0; k <= 1000; ++k) {
        const double t = 2.0 * k / 1000;
        const Vec3 exact{-9 * std::sin(9 * t), std::exp(t), 3 * t * t};
        CHECK(distance(evaluate_derivative(curve, t), exact) < 1e-10 * norm(exact));
    }
    CHECK_FALSE(curve.closed);
}

TEST_CASE("forty waves over a formula's range are still differentiated") {
    const Curve curve = formula(
        [](double t) {
            return Vec3{t, 0.01 * std::sin(80 * pi * t), 0};
        },
        0, 1);
    for (int k = 10; k <= 990; ++k) {
        const double t = k / 1000.0;
        const Vec3 exact{1, 0.8 * pi * std::cos(80 * pi * t), 0};
        CHECK(distance(evaluate_derivative(curve, t), exact) < 1e-9 * norm(exact));
    }
}

TEST_CASE("a formula that comes back is closed") {
    const Curve loop = formula(
        [](double t) {
            return Vec3{std::cos(t), std::sin(t), 0};
        },
        0, 2 * pi);
    CHECK(loop.closed);
    CHECK(evaluate(loop, loop.begin) == evaluate(loop, loop.end));
    CHECK(arc_length(loop, loop.begin, loop.end) == Approx(2 * pi).epsilon(1e-12));
    const Curve figure = formula([](double t) { return Vec3{1e3 + t * (1 - t), t, 0}; }, 0, 1);
    CHECK_FALSE(figure.closed);
}
