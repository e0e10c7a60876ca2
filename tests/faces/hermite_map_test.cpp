// SPDX-License-Identifier: Apache-2.0
#include "faces/hermite_map.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace hexweave;

namespace {

constexpr int cells_i = 23;
constexpr int cells_j = 17;

/// Increasing from 0 to 1 in steps of very unequal size.
std::vector<double> random_monotone(std::mt19937& random, int cells, double spread) {
    std::uniform_real_distribution<double> exponent(-spread, 0);
    std::vector<double> line{0};
    for (int n = 0; n < cells; ++n) line.push_back(line.back() + std::pow(10, exponent(random)));
    for (double& value : line) value /= line.back();
    return line;
}

EdgeFunctions random_edges(std::mt19937& random, double spread) {
    return {random_monotone(random, cells_j, spread), random_monotone(random, cells_j, spread),
            random_monotone(random, cells_i, spread), random_monotone(random, cells_i, spread)};
}

std::array<bool, 4> sides_of(int bits) {
    return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
}

}  // namespace

TEST_CASE("the Hermite map has the edge functions on its boundary, to the bit") {
    std::mt19937 random(1);
    for (int bits = 0; bits < 16; ++bits) {
        const EdgeFunctions edges = random_edges(random, 3);
        const ParameterField map = hermite_map(edges, sides_of(bits));
        for (int j = 0; j <= cells_j; ++j) {
            const auto row = static_cast<std::size_t>(j);
            CHECK(map.s(0, j) == 0);
            CHECK(map.s(cells_i, j) == 1);
            CHECK(map.t(0, j) == edges[0][row]);
            CHECK(map.t(cells_i, j) == edges[1][row]);
        }
        for (int i = 0; i <= cells_i; ++i) {
            const auto column = static_cast<std::size_t>(i);
            CHECK(map.t(i, 0) == 0);
            CHECK(map.t(i, cells_j) == 1);
            CHECK(map.s(i, 0) == edges[2][column]);
            CHECK(map.s(i, cells_j) == edges[3][column]);
        }
    }
}

TEST_CASE("equal functions on opposite edges are carried through the face unchanged") {
    std::mt19937 random(2);
    const EdgeFunctions some = random_edges(random, 2);
    const ParameterField map = hermite_map({some[0], some[0], some[2], some[2]}, sides_of(15));
    for (int j = 0; j <= cells_j; ++j) {
        for (int i = 0; i <= cells_i; ++i) {
            CHECK(map.s(i, j) == some[2][static_cast<std::size_t>(i)]);
            CHECK(map.t(i, j) == some[0][static_cast<std::size_t>(j)]);
        }
    }
}

TEST_CASE("with no orthogonal side the map is that of straight lines") {
    PointField boundary({9, 7, 1});
    for (int j = 0; j < 7; ++j) {
        for (int i = 0; i < 9; ++i) {
            boundary.set(i, j, 0, {i + 0.3 * j * i, j * j + 0.1 * i * i, 0.2 * i});
        }
    }
    const ParameterField straight = straight_line_map(boundary);
    EdgeFunctions edges;
    for (int j = 0; j < 7; ++j) {
        edges[0].push_back(straight.t(0, j));
        edges[1].push_back(straight.t(8, j));
    }
    for (int i = 0; i < 9; ++i) {
        edges[2].push_back(straight.s(i, 0));
        edges[3].push_back(straight.s(i, 6));
    }
    const ParameterField map = hermite_map(edges, sides_of(0));
    for (std::size_t n = 0; n < boundary.extent().nodes(); ++n) {
        CHECK(map.s[n] == Approx(straight.s[n]).margin(1e-15));
        CHECK(map.t[n] == Approx(straight.t[n]).margin(1e-15));
    }
}

TEST_CASE("lines of any monotone edge functions meet inside the square, on both curves") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto worse = [](double far, double near, double share, double value) {
        return std::abs((1 - share) * near + share * far - value);
    };
    double worst = 0;
    for (int n = 0; n < 200000; ++n) {
        const std::array<bool, 4> sides = sides_of(n % 16);
        const LineEnds lines_of_i{sides[2], sides[3]};
        const LineEnds lines_of_j{sides[0], sides[1]};
        const double s0 = uniform(random), s1 = uniform(random);
        const double t0 = uniform(random), t1 = uniform(random);
        const SquarePoint p = curved_line_point(s0, s1, lines_of_i, t0, t1, lines_of_j);
        REQUIRE((p.s >= 0 && p.s <= 1 && p.t >= 0 && p.t <= 1));
        worst = std::max({worst, worse(s1, s0, lines_of_i.far_share(p.t), p.s),
                          worse(t1, t0, lines_of_j.far_share(p.s), p.t)});
    }
    CHECK(worst < 1e-14);
}

TEST_CASE("lines leave the sides where they are to be orthogonal upright, and only those") {
    constexpr double step = 1e-4;
    for (int bits = 0; bits < 4; ++bits) {
        const LineEnds crossing{(bits & 1) != 0, (bits & 2) != 0};
        CHECK(crossing.far_share(0) == 0);
        CHECK(crossing.far_share(1) == 1);
        const double at_start = crossing.far_share(step) / step;
        const double at_end = (1 - crossing.far_share(1 - step)) / step;
        CHECK((at_start < 4 * step) == crossing.upright_at_start);
        CHECK((at_end < 4 * step) == crossing.upright_at_end);
        for (const double f : {0.1, 0.35, 0.8}) {
            const double slope =
                (crossing.far_share(f + step) - crossing.far_share(f - step)) / (2 * step);
            CHECK(crossing.slope(f) == Approx(slope).epsilon(1e-6));
            CHECK(slope > 0);
        }
    }
}

TEST_CASE("the mirror image of the edge functions gives the mirror image of the map") {
    std::mt19937 random(4);
    const EdgeFunctions edges = random_edges(random, 1);
    const auto turned = [](std::vector<double> line) {
        std::reverse(line.begin(), line.end());
        for (double& value : line) value = 1 - value;
        return line;
    };
    const std::array<bool, 4> sides{true, false, true, true};
    const std::array<bool, 4> mirrored_sides{false, true, true, true};
    const ParameterField map = hermite_map(edges, sides);
    const ParameterField mirrored =
        hermite_map({edges[1], edges[0], turned(edges[2]), turned(edges[3])}, mirrored_sides);
    for (int j = 0; j <= cells_j; ++j) {
        for (int i = 0; i <= cells_i; ++i) {
            CHECK(mirrored.s(cells_i - i, j) == Approx(1 - map.s(i, j)).margin(1e-14));
            CHECK(mirrored.t(cells_i - i, j) == Approx(map.t(i, j)).margin(1e-14));
        }
    }
}
