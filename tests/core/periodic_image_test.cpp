// SPDX-License-Identifier: Apache-2.0
#include "core/periodic_image.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace hexweave;

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("a translation adds the way, to the bit") {
    const PeriodicMap map = periodic_map({{5, 6, 7}, {}, {0, 0.7, -2}});
    CHECK(image(map, {0.1, 0.1, 0.3}) == Vec3{0.1, 0.1 + 0.7, 0.3 - 2});
    CHECK(image_of_way(map, {1, 2, 3}) == Vec3{1, 2, 3});
}

TEST_CASE("quarter turns are exact") {
    const Vec3 p{0.1, 0.2, 0.3};
    CHECK(image(periodic_map({{}, {0, 0, pi / 2}, {}}), p) == Vec3{-0.2, 0.1, 0.3});
    CHECK(image(periodic_map({{}, {0, 0, -pi / 2}, {}}), p) == Vec3{0.2, -0.1, 0.3});
    CHECK(image(periodic_map({{}, {0, 0, 3 * pi / 2}, {}}), p) == Vec3{0.2, -0.1, 0.3});
    CHECK(image(periodic_map({{}, {pi / 2, 0, 0}, {}}), p) == Vec3{0.1, -0.3, 0.2});
    CHECK(image(periodic_map({{}, {0, pi / 2, 0}, {}}), p) == Vec3{0.3, 0.2, -0.1});
    CHECK(image(periodic_map({{}, {pi, 0, 0}, {}}), p) == Vec3{0.1, -0.2, -0.3});
}

TEST_CASE("points of the axis stay where they are, and so does the place along it") {
    const Vec3 center{0.1, 0.7, 0.3};
    const PeriodicMap map = periodic_map({center, {0, 0.3, 0}, {}});
    CHECK(image(map, {0.1, 1.1, 0.3}) == Vec3{0.1, 1.1, 0.3});
    CHECK(image(map, {0.4, 1.1, 0.9}).y == 1.1);
}

TEST_CASE("a turn is right-handed and keeps lengths; the way back leads back") {
    const Periodicity periodicity{{1, 2, 3}, {0.2, 0, 0}, {}};
    const PeriodicMap map = periodic_map(periodicity);
    const Vec3 p{4, 2.5, -1};
    const Vec3 q = image(map, p);
    CHECK(distance(q, periodicity.center) ==
          Approx(distance(p, periodicity.center)).epsilon(1e-15));
    CHECK(image_of_way(map, {0, 1, 0}).z == Approx(std::sin(0.2)).epsilon(1e-15));
    CHECK(distance(image(periodic_map(backwards(periodicity)), q), p) <= image_rounding(map, p));
}

TEST_CASE("turns about several axes follow each other: about x, then y, then z") {
    const Vec3 angle{0.3, -0.4, 0.5};
    const Vec3 p{1, 2, 3};
    Vec3 q = p;
    q = image(periodic_map({{}, {angle.x, 0, 0}, {}}), q);
    q = image(periodic_map({{}, {0, angle.y, 0}, {}}), q);
    q = image(periodic_map({{}, {0, 0, angle.z}, {}}), q);
    CHECK(distance(image(periodic_map({{}, angle, {}}), p), q) < 1e-15);
}
