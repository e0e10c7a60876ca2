// SPDX-License-Identifier: Apache-2.0
#include "faces/factor_layer.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace hexweave;

namespace {

/// Lines off a wall jmin, equally far apart in space; `x` of node i, and of node k along z.
template <class Stretching>
PointField sheets(int count_i, int count_k, Stretching&& x) {
    PointField points(Extent{count_i, 2, count_k});
    for (int k = 0; k < count_k; ++k) {
        for (int j = 0; j < 2; ++j) {
            for (int i = 0; i < count_i; ++i) {
                const double z = count_k == 1 ? 0.0 : x(k / (count_k - 1.0));
                points.set(i, j, k, {x(i / (count_i - 1.0)), static_cast<double>(j), z});
            }
        }
    }
    return points;
}

double even(double s) {
    return s;
}
double clustered(double s) {
    return s * s * s;
}

/// Factors and widening at every node of a side.
template <class Factor>
FactorLayer layer_of(const PointField& points, const WallFrame& wall, double widening,
                     Factor&& factor) {
    FactorLayer layer(wall);
    for (int b = 0; b < wall.count_b; ++b) {
        for (int a = 0; a < wall.count_a; ++a) {
            const Vec3 at = points[wall.offset(a, b, 1)];
            layer.log_factors(a, b) = factor(at.x, at.z);
            layer.widening(a, b) = widening;
        }
    }
    return layer;
}

}  // namespace

TEST_CASE("a wave along the wall falls like a bell of variance half the squared distance") {
    const auto wave = [](double x, double) { return std::sin(4 * std::numbers::pi * x); };
    const PointField points = sheets(401, 1, even);
    const WallFrame wall(points.extent(), Side::jmin);
    constexpr int steps = 400;
    const double distance = 0.1;
    FactorLayer layer = layer_of(points, wall, distance * distance / steps, wave);
    for (int step = 0; step < steps; ++step) smooth_along_wall(layer, points, wall, 1);
    const double wave_number = 4 * std::numbers::pi;
    const double expected = std::exp(-0.5 * wave_number * wave_number * distance * distance / 2);
    for (int i = 0; i <= 400; ++i) {
        CHECK(layer.log_factors(i, 0) == Approx(expected * wave(i / 400.0, 0)).margin(2e-3));
    }
}

TEST_CASE("factors that are linear along the wall stay, however the nodes are spaced") {
    const auto plane = [](double x, double z) { return 2 - 3 * x + 0.5 * z; };
    const PointField points = sheets(21, 11, clustered);
    const WallFrame wall(points.extent(), Side::jmin);
    FactorLayer layer = layer_of(points, wall, 4, plane);
    smooth_along_wall(layer, points, wall, 1);
    for (int b = 0; b < wall.count_b; ++b) {
        for (int a = 0; a < wall.count_a; ++a) {
            const Vec3 at = points[wall.offset(a, b, 1)];
            CHECK(layer.log_factors(a, b) == Approx(plane(at.x, at.z)).epsilon(1e-9));
        }
    }
}

TEST_CASE("smoothed factors lie between their neighbours, and those at the ends stay") {
    const auto rough = [](double x, double z) { return std::sin(1e4 * (x + 3 * z)); };
    const PointField points = sheets(21, 11, clustered);
    const WallFrame wall(points.extent(), Side::jmin);
    const FactorLayer before = layer_of(points, wall, 0.05, rough);
    FactorLayer layer = before;
    smooth_along_wall(layer, points, wall, 1);
    for (int b = 0; b < wall.count_b; ++b) {
        for (int a = 0; a < wall.count_a; ++a) {
            CHECK(std::abs(layer.log_factors(a, b)) <= 1);
            if (wall.fixed(a, b) && (a == 0 || a == wall.count_a - 1) && (b == 0 || b == 10)) {
                CHECK(layer.log_factors(a, b) == before.log_factors(a, b));
            }
        }
    }
    FactorLayer still = layer_of(points, wall, 0, rough);
    smooth_along_wall(still, points, wall, 1);
    for (int a = 0; a < wall.count_a; ++a) {
        CHECK(still.log_factors(a, 5) == before.log_factors(a, 5));
    }
}

TEST_CASE("nodes of a wall that lie on one another, as at a pole, have one factor") {
    const PointField points = sheets(21, 1, [](double s) { return s < 0.3 || s > 0.7 ? s : 0.5; });
    const WallFrame wall(points.extent(), Side::jmin);
    FactorLayer layer = layer_of(points, wall, 0.01, [](double x, double) { return x; });
    for (int i = 6; i <= 14; ++i) layer.log_factors(i, 0) = i % 2;
    smooth_along_wall(layer, points, wall, 1);
    for (int i = 7; i <= 13; ++i) {
        CHECK(layer.log_factors(i, 0) == Approx(layer.log_factors(6, 0)).margin(1e-6));
    }
}
