// SPDX-License-Identifier: Apache-2.0
#include "faces/straight_line_map.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "faces/arc_length.h"

using namespace hexweave;

namespace {

/// A strictly increasing sequence from 0 to 1 whose steps range over many orders of magnitude.
std::vector<double> random_distribution(std::mt19937& random, int cells, double smallest) {
    std::uniform_real_distribution<double> exponent(std::log(smallest), 0);
    std::vector<double> values{0};
    for (int n = 0; n < cells; ++n) values.push_back(values.back() + std::exp(exponent(random)));
    for (double& value : values) value /= values.back();
    return values;
}

/// A face over the unit square whose four sides have the given distributions.
PointField square_boundary(const std::vector<double>& jmin, const std::vector<double>& jmax,
                           const std::vector<double>& imin, const std::vector<double>& imax) {
    const int ni = static_cast<int>(jmin.size());
    const int nj = static_cast<int>(imin.size());
    PointField points(Extent{ni, nj, 1});
    for (int i = 0; i < ni; ++i) {
        points.set(i, 0, 0, {jmin[static_cast<std::size_t>(i)], 0, 0});
        points.set(i, nj - 1, 0, {jmax[static_cast<std::size_t>(i)], 1, 0});
    }
    for (int j = 0; j < nj; ++j) {
        points.set(0, j, 0, {0, imin[static_cast<std::size_t>(j)], 0});
        points.set(ni - 1, j, 0, {1, imax[static_cast<std::size_t>(j)], 0});
    }
    return points;
}

/// Eqs. (39), (40) by Newton's method in extended precision.
std::array<long double, 2> by_newton(long double a0, long double a1, long double b0,
                                     long double b1) {
    long double s = 0.5L;
    long double t = 0.5L;
    for (int n = 0; n < 4; ++n) {
        const long double f = s - a0 * (1 - t) - a1 * t;
        const long double g = t - b0 * (1 - s) - b1 * s;
        const long double determinant = 1 - (a1 - a0) * (b1 - b0);
        const long double ds = f + (a1 - a0) * g;
        const long double dt = g + (b1 - b0) * f;
        s -= ds / determinant;
        t -= dt / determinant;
    }
    return {s, t};
}

}  // namespace

TEST_CASE("normalized arc length runs from exactly 0 to exactly 1 and is exact on a 3-4-5 path") {
    const std::vector<Vec3> line{{0, 0, 0}, {3, 4, 0}, {3, 4, 10}, {9, 12, 10}, {9, 7, 10}};
    CHECK(normalized_arc_length(line) == std::vector<double>{0, 5.0 / 30, 15.0 / 30, 25.0 / 30, 1});
}

TEST_CASE("the straight-line map agrees with Newton's method in extended precision") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int n = 0; n < 20000; ++n) {
        const double a0 = uniform(random), a1 = uniform(random);
        const double b0 = uniform(random), b1 = uniform(random);
        const SquarePoint point = straight_line_point(a0, a1, b0, b1);
        const auto [s, t] = by_newton(a0, a1, b0, b1);
        REQUIRE(std::abs(point.s - static_cast<double>(s)) < 1e-15);
        REQUIRE(std::abs(point.t - static_cast<double>(t)) < 1e-15);
    }
}

TEST_CASE("the straight-line map keeps its digits where both lines run from corner to corner") {
    // By symmetry the two lines cross in the centre; 1 - (1 - 2e)^2 has lost its digits there.
    for (const int power : {-20, -30, -40, -50}) {
        const double e = std::ldexp(1.0, power);
        const SquarePoint centre = straight_line_point(e, 1 - e, e, 1 - e);
        CHECK(centre.s == Approx(0.5).epsilon(1e-15));
        CHECK(centre.t == Approx(0.5).epsilon(1e-15));
    }
}

TEST_CASE("the straight-line map keeps the boundary to the bit and equal sides everywhere") {
    std::mt19937 random(11);
    const auto a = random_distribution(random, 12, 1e-8);
    const auto b = random_distribution(random, 9, 1e-8);
    const auto c = random_distribution(random, 9, 1e-2);
    const PointField points = square_boundary(a, a, b, c);
    const ParameterField p = straight_line_map(points);
    const auto t_imin = normalized_arc_length(grid_line(points, {0, 0, 0}, 1));
    const auto t_imax = normalized_arc_length(grid_line(points, {12, 0, 0}, 1));
    const auto s_jmin = normalized_arc_length(grid_line(points, {0, 0, 0}, 0));
    for (int j = 0; j <= 9; ++j) {
        CHECK(p.s(0, j) == 0);
        CHECK(p.s(12, j) == 1);
        CHECK(p.t(0, j) == t_imin[static_cast<std::size_t>(j)]);
        CHECK(p.t(12, j) == t_imax[static_cast<std::size_t>(j)]);
        for (int i = 0; i <= 12; ++i) CHECK(p.s(i, j) == s_jmin[static_cast<std::size_t>(i)]);
    }
    for (int i = 0; i <= 12; ++i) {
        CHECK(p.t(i, 0) == 0);
        CHECK(p.t(i, 9) == 1);
    }
}

TEST_CASE("the straight-line map is one-to-one for sides clustered to 1e-8 of their length") {
    std::mt19937 random(3);
    for (int n = 0; n < 200; ++n) {
        const PointField points = square_boundary(
            random_distribution(random, 8, 1e-8), random_distribution(random, 8, 1e-8),
            random_distribution(random, 8, 1e-8), random_distribution(random, 8, 1e-8));
        const ParameterField p = straight_line_map(points);
        for (int j = 0; j < 8; ++j) {
            for (int i = 0; i < 8; ++i) {
                // Each cell of the image: s grows along i, t along j, and its area is positive.
                const double si = p.s(i + 1, j) - p.s(i, j);
                const double ti = p.t(i + 1, j) - p.t(i, j);
                const double sj = p.s(i, j + 1) - p.s(i, j);
                const double tj = p.t(i, j + 1) - p.t(i, j);
                REQUIRE(si > 0);
                REQUIRE(tj > 0);
                REQUIRE(si * tj - ti * sj > 0);
            }
        }
    }
}

TEST_CASE("the straight-line map of a transposed face is its transpose, to the bit") {
    std::mt19937 random(5);
    const auto a = random_distribution(random, 6, 1e-6), b = random_distribution(random, 6, 1e-6);
    const auto c = random_distribution(random, 4, 1e-6), d = random_distribution(random, 4, 1e-6);
    const ParameterField p = straight_line_map(square_boundary(a, b, c, d));
    const ParameterField q = straight_line_map(square_boundary(c, d, a, b));
    for (int j = 0; j <= 4; ++j) {
        for (int i = 0; i <= 6; ++i) {
            CHECK(p.s(i, j) == q.t(j, i));
            CHECK(p.t(i, j) == q.s(j, i));
        }
    }
}
