// SPDX-License-Identifier: Apache-2.0
#include "blocks/bilinear_map.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "core/orientation.h"
#include "core/vec3.h"
#include "faces/arc_length.h"
#include "faces/straight_line_map.h"

using namespace hexweave;

namespace {

using Four = std::array<double, 4>;

double bilinear(const Four& v, double a, double b) {
    return v[0] * (1 - a) * (1 - b) + v[1] * a * (1 - b) + v[2] * (1 - a) * b + v[3] * a * b;
}

/// The greatest residual of eqs. (90)-(92), as they are printed.
double residual(const EdgeStations& e, const CubePoint& p) {
    return std::max({std::abs(p.s - bilinear(e.s, p.t, p.u)),
                     std::abs(p.t - bilinear(e.t, p.s, p.u)),
                     std::abs(p.u - bilinear(e.u, p.s, p.t))});
}

/// The determinant of the equations: positive at the root that a one-to-one map has.
double determinant(const EdgeStations& e, const CubePoint& p) {
    const auto first = [](const Four& v, double b) {
        return (v[1] - v[0]) * (1 - b) + (v[3] - v[2]) * b;
    };
    const auto second = [](const Four& v, double a) {
        return (v[2] - v[0]) * (1 - a) + (v[3] - v[1]) * a;
    };
    const Vec3 row_s{1, -first(e.s, p.u), -second(e.s, p.t)};
    const Vec3 row_t{-first(e.t, p.u), 1, -second(e.t, p.s)};
    const Vec3 row_u{-first(e.u, p.t), -second(e.u, p.s), 1};
    return triple(row_s, row_t, row_u);
}

bool in_cube(const CubePoint& p) {
    return p.s >= 0 && p.s <= 1 && p.t >= 0 && p.t <= 1 && p.u >= 0 && p.u <= 1;
}

std::vector<double> random_distribution(std::mt19937& random, int cells, double smallest) {
    std::uniform_real_distribution<double> exponent(std::log(smallest), 0);
    std::vector<double> values{0};
    for (int n = 0; n < cells; ++n) values.push_back(values.back() + std::exp(exponent(random)));
    for (double& value : values) value /= values.back();
    return values;
}

/// The boundary of a unit cube whose twelve edges have random distributions; only the edges are
/// set.
PointField random_cube(std::mt19937& random, const Extent& e, double smallest) {
    PointField points(e);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (unsigned corner = 0; corner < 8; ++corner) {
            if (corner & (1U << axis)) continue;
            const int cells = e[static_cast<int>(axis)] - 1;
            const auto values = random_distribution(random, cells, smallest);
            for (int n = 0; n <= cells; ++n) {
                std::array<double, 3> x{};
                Node node{};
                for (std::size_t a = 0; a < 3; ++a) {
                    const bool high = (corner & (1U << a)) != 0;
                    x[a] = high ? 1 : 0;
                    node[a] = high ? e[static_cast<int>(a)] - 1 : 0;
                }
                x[axis] = values[static_cast<std::size_t>(n)];
                node[axis] = n;
                points.set(node[0], node[1], node[2], {x[0], x[1], x[2]});
            }
        }
    }
    return points;
}

}  // namespace

TEST_CASE("the bilinear map solves its equations for any stations, inside the cube") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int n = 0; n < 100000; ++n) {
        // Powers push the stations towards the ends, where plain iterations fail.
        const double power = 1 + (n % 7) * 3;
        const auto draw = [&] {
            Four values{};
            for (double& v : values) {
                v = std::pow(uniform(random), power);
                if (uniform(random) < 0.5) v = 1 - v;
            }
            return values;
        };
        const EdgeStations e{draw(), draw(), draw()};
        const CubePoint p = bilinear_point(e);
        REQUIRE(in_cube(p));
        REQUIRE(residual(e, p) < 1e-14);
        REQUIRE(determinant(e, p) > 0);
    }
}

TEST_CASE("permuting the axes of the bilinear map permutes its point") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int n = 0; n < 2000; ++n) {
        EdgeStations e;
        for (double& v : e.s) v = uniform(random);
        for (double& v : e.t) v = uniform(random);
        for (double& v : e.u) v = uniform(random);
        const CubePoint p = bilinear_point(e);
        // (s, t, u) -> (u, s, t): stations are listed by the other two coordinates, ascending.
        const auto swapped = [](const Four& v) { return Four{v[0], v[2], v[1], v[3]}; };
        const CubePoint q = bilinear_point({e.u, swapped(e.s), swapped(e.t)});
        const double scale = 1e-14 / std::min(1.0, determinant(e, p));
        REQUIRE(std::abs(q.s - p.u) < scale);
        REQUIRE(std::abs(q.t - p.s) < scale);
        REQUIRE(std::abs(q.u - p.t) < scale);
    }
}

TEST_CASE("the bilinear map is exact on edges and sides, and the straight-line map in the sides") {
    std::mt19937 random(4);
    const Extent e{7, 6, 5};
    for (int n = 0; n < 20; ++n) {
        const PointField points = random_cube(random, e, 1e-8);
        const ParameterField p = bilinear_map(points);
        const auto edge = normalized_arc_length(grid_line(points, {6, 5, 0}, 2));
        for (int k = 0; k < 5; ++k) {
            CHECK(p.u(6, 5, k) == edge[static_cast<std::size_t>(k)]);
            for (int j = 0; j < 6; ++j) {
                CHECK(p.s(0, j, k) == 0);
                CHECK(p.s(6, j, k) == 1);
            }
            for (int i = 0; i < 7; ++i) {
                CHECK(p.t(i, 0, k) == 0);
                CHECK(p.t(i, 5, k) == 1);
            }
        }
        const auto s0 = normalized_arc_length(grid_line(points, {0, 0, 4}, 0));
        const auto s1 = normalized_arc_length(grid_line(points, {0, 5, 4}, 0));
        const auto t0 = normalized_arc_length(grid_line(points, {0, 0, 4}, 1));
        const auto t1 = normalized_arc_length(grid_line(points, {6, 0, 4}, 1));
        for (int j = 0; j < 6; ++j) {
            for (int i = 0; i < 7; ++i) {
                const auto column = static_cast<std::size_t>(i);
                const auto row = static_cast<std::size_t>(j);
                const SquarePoint q = straight_line_point(s0[column], s1[column], t0[row], t1[row]);
                CHECK(p.u(i, j, 0) == 0);
                CHECK(p.u(i, j, 4) == 1);
                CHECK(p.s(i, j, 4) == q.s);
                CHECK(p.t(i, j, 4) == q.t);
            }
        }
    }
}

TEST_CASE(
    "the bilinear map is monotone along each axis for edges clustered to 1e-8 of their length") {
    std::mt19937 random(6);
    const Extent e{6, 6, 6};
    for (int n = 0; n < 100; ++n) {
        const ParameterField p = bilinear_map(random_cube(random, e, 1e-8));
        const auto at = [&](int i, int j, int k) {
            return Vec3{p.s(i, j, k), p.t(i, j, k), p.u(i, j, k)};
        };
        for (int k = 0; k < 5; ++k) {
            for (int j = 0; j < 5; ++j) {
                for (int i = 0; i < 5; ++i) {
                    const Vec3 a = at(i + 1, j, k) - at(i, j, k);
                    const Vec3 b = at(i, j + 1, k) - at(i, j, k);
                    const Vec3 c = at(i, j, k + 1) - at(i, j, k);
                    REQUIRE(a.x > 0);
                    REQUIRE(b.y > 0);
                    REQUIRE(c.z > 0);
                }
            }
        }
    }
}

TEST_CASE("with the same distribution on parallel edges the bilinear map is their product") {
    std::mt19937 random(8);
    const auto a = random_distribution(random, 6, 1e-8);
    const auto b = random_distribution(random, 5, 1e-8);
    for (const double x : a) {
        for (const double y : b) {
            const CubePoint p = bilinear_point({{x, x, x, x}, {y, y, y, y}, {x, x, x, x}});
            CHECK(p.s == x);
            CHECK(p.t == y);
            CHECK(p.u == x);
        }
    }
}
