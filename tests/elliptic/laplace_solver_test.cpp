// SPDX-License-Identifier: Apache-2.0
#include "elliptic/laplace_solver.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "elliptic/shapes.h"

namespace hexweave {
namespace {

constexpr std::array<bool, 4> i_sides{true, true, false, false};
constexpr std::array<bool, 4> j_sides{false, false, true, true};

/// A start that has nothing but the boundary values right.
Field zero_to_one(const Extent& extent, int axis) {
    Field values(extent, 0.5);
    for (int j = 0; j < extent.nj; ++j) {
        for (int i = 0; i < extent.ni; ++i) {
            const int n = axis == 0 ? i : j;
            if (n == 0) values(i, j) = 0;
            if (n == extent[axis] - 1) values(i, j) = 1;
        }
    }
    return values;
}

/// A quarter annulus on the plane, or rolled up without strain: Laplace's equation is the same.
Vec3 rolled_annulus(const Vec3& s) {
    const Vec3 p = shapes::annulus(s);
    return {std::sin(p.x), p.y, std::cos(p.x)};
}

}  // namespace

TEST_CASE("log r and the angle of an annulus come out with second order on a leaning grid") {
    for (const bool rolled : {false, true}) {
        for (const int axis : {0, 1}) {
            std::vector<double> errors;
            for (const int n : {16, 32, 64}) {
                const Extent extent{n + 1, n + 1, 1};
                const PointField points =
                    shapes::sample(extent, [&](double xi, double eta, double) {
                        Vec3 s = shapes::leaning(xi, eta, 0);
                        s.z = 0;
                        return rolled ? rolled_annulus(s) : shapes::annulus(s);
                    });
                const PointField exact = shapes::sample(extent, shapes::leaning);
                Field values = zero_to_one(extent, axis);
                const LaplaceResult result = solve_laplace(
                    LaplaceHierarchy(points), axis == 0 ? i_sides : j_sides, {1e-9, 50}, values);
                REQUIRE(result.converged);
                double error = 0;
                for (std::size_t p = 0; p < extent.nodes(); ++p) {
                    const double known = axis == 0 ? exact.x[p] : exact.y[p];
                    error = std::max(error, std::abs(values[p] - known));
                }
                errors.push_back(error);
            }
            INFO(rolled << axis << ": " << errors[0] << ", " << errors[1] << ", " << errors[2]);
            CHECK(std::log2(errors[0] / errors[1]) > 1.8);
            CHECK(std::log2(errors[1] / errors[2]) > 1.9);
        }
    }
}

namespace {

/// An ellipse's half plane between two confocal ellipses, thick at the inner one, with lines that
/// lean and wave: nearly a plate, so that cells at its ends are thin in both directions.
PointField round_a_plate(int ni, int nj, double first) {
    const auto heights = shapes::geometric(nj, first);
    const auto stations = shapes::geometric(ni, 0.3 / ni);
    return shapes::sample({ni + 1, nj + 1, 1}, [&](double xi, double eta, double) {
        const double r = heights[static_cast<std::size_t>(std::lround(eta * nj))];
        const double u = stations[static_cast<std::size_t>(std::lround(xi * ni))];
        const double angle = std::acos(-1.0) * (u + 0.1 * u * (1 - u) * std::sin(2 * r));
        return Vec3{std::cosh(0.05 + 3 * r) * std::cos(angle),
                    std::sinh(0.05 + 3 * r) * std::sin(angle), 0};
    });
}

}  // namespace

TEST_CASE("the number of cycles does not grow with the grid nor with the aspect of its cells") {
    // The cells at the wall are up to 1e6 times as long as high.
    for (const double first : {1e-3, 1e-5, 1e-7}) {
        for (const auto& [ni, nj] :
             {std::array{32, 24}, {97, 41}, {128, 64}, {255, 129}, {5, 200}, {200, 5}}) {
            const PointField points = round_a_plate(ni, nj, nj == 5 ? 0.1 : first);
            const LaplaceHierarchy hierarchy(points);
            for (const int axis : {0, 1}) {
                Field values = zero_to_one(points.extent(), axis);
                const LaplaceResult result =
                    solve_laplace(hierarchy, axis == 0 ? i_sides : j_sides, {1e-6, 60}, values);
                INFO(first << ", " << ni << " x " << nj << ", axis " << axis);
                CHECK(result.converged);
                CHECK(result.cycles <= 10);
            }
        }
    }
}

TEST_CASE("the cells' own coordinate is harmonic on any grid of rectangles, exactly") {
    const auto xs = shapes::geometric(19, 1e-4);
    const auto ys = shapes::geometric(12, 1e-6);
    const PointField points = shapes::sample({20, 13, 1}, [&](double xi, double eta, double) {
        return Vec3{xs[static_cast<std::size_t>(std::lround(19 * xi))],
                    ys[static_cast<std::size_t>(std::lround(12 * eta))], 0};
    });
    const LaplaceHierarchy hierarchy(points);
    for (const int axis : {0, 1}) {
        Field values = zero_to_one(points.extent(), axis);
        REQUIRE(
            solve_laplace(hierarchy, axis == 0 ? i_sides : j_sides, {1e-9, 50}, values).converged);
        const Field& exact = axis == 0 ? points.x : points.y;
        for (std::size_t p = 0; p < points.extent().nodes(); ++p) {
            CHECK(values[p] == Approx(exact[p]).epsilon(1e-8).margin(1e-13));
        }
    }
}

TEST_CASE("given values stay to the bit, and the start does not matter") {
    const PointField points = round_a_plate(33, 20, 1e-4);
    const LaplaceHierarchy hierarchy(points);
    Field first(points.extent());
    for (std::size_t p = 0; p < points.extent().nodes(); ++p) {
        first[p] = 0.3 * points.x[p] + std::sin(points.y[p]);
    }
    Field second = first;
    for (int j = 1; j < 20; ++j) {
        for (int i = 0; i < 33; ++i) second(i, j) = 7 * std::cos(11.0 * i * j);
    }
    const Field given = first;
    const std::array<bool, 4> fixed{false, true, true, true};
    REQUIRE(solve_laplace(hierarchy, fixed, {1e-10, 60}, first).converged);
    REQUIRE(solve_laplace(hierarchy, fixed, {1e-10, 60}, second).converged);
    for (int j = 0; j <= 20; ++j) {
        CHECK(first(33, j) == given(33, j));
        for (int i = 0; i <= 33; ++i) {
            if (j == 0 || j == 20) CHECK(first(i, j) == given(i, j));
            CHECK(first(i, j) == Approx(second(i, j)).margin(1e-9));
        }
    }
}

TEST_CASE("seen in a mirror, or with i and j exchanged, the solution is the same") {
    const PointField points = round_a_plate(24, 17, 1e-3);
    const Extent e = points.extent();
    PointField mirrored(e);
    PointField exchanged({e.nj, e.ni, 1});
    for (int j = 0; j < e.nj; ++j) {
        for (int i = 0; i < e.ni; ++i) {
            const Vec3 p = points(i, j);
            mirrored.set(e.ni - 1 - i, j, 0, {-p.x, p.y, 0});
            exchanged.set(j, i, 0, {p.y, p.x, 0});
        }
    }
    const auto solved = [](const PointField& grid, int axis) {
        Field values = zero_to_one(grid.extent(), axis);
        REQUIRE(solve_laplace(LaplaceHierarchy(grid), axis == 0 ? i_sides : j_sides, {1e-10, 60},
                              values)
                    .converged);
        return values;
    };
    const Field s = solved(points, 0);
    const Field in_mirror = solved(mirrored, 0);
    const Field with_axes_exchanged = solved(exchanged, 1);
    for (int j = 0; j < e.nj; ++j) {
        for (int i = 0; i < e.ni; ++i) {
            CHECK(in_mirror(e.ni - 1 - i, j) == Approx(1 - s(i, j)).margin(1e-9));
            CHECK(with_axes_exchanged(j, i) == Approx(s(i, j)).margin(1e-9));
        }
    }
}

namespace {

/// What a network spends: conductance times difference squared, over all joints.
double power(const Conductances& network, const Field& v) {
    double sum = 0;
    const auto spent = [&](double conductance, double difference) {
        sum += conductance * difference * difference;
    };
    for (int j = 1; j <= network.nj; ++j) {
        for (int i = 1; i <= network.ni; ++i) {
            spent(network.east(i, j), v(i + 1, j) - v(i, j));
            spent(network.north(i, j), v(i, j + 1) - v(i, j));
            spent(network.rising(i, j), v(i + 1, j + 1) - v(i, j));
            spent(network.falling(i, j), v(i, j + 1) - v(i + 1, j));
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("a coarse network spends what the fine one does at the interpolated field") {
    for (const auto& [ni, nj] : {std::array{9, 7}, {8, 11}, {3, 6}, {4, 2}}) {
        const PointField points = shapes::sample({ni, nj, 1}, shapes::leaning);
        const Conductances fine = laplace_conductances(points);
        const AxisCoarsening along_i(ni);
        const AxisCoarsening along_j(nj);
        const Conductances coarse = coarsen(fine, along_i, along_j);
        Field v(coarse.east.extent());
        for (int j = 1; j <= coarse.nj; ++j) {
            for (int i = 1; i <= coarse.ni; ++i) v(i, j) = std::sin(5.0 * i + 3.0 * j * j);
        }
        Field interpolated(fine.east.extent());
        for (int j = 0; j < nj; ++j) {
            for (int i = 0; i < ni; ++i) {
                const int a = along_i.cell_of(i);
                const int b = along_j.cell_of(j);
                const double f = along_i.fraction(i, a);
                const double g = along_j.fraction(j, b);
                interpolated(i + 1, j + 1) =
                    (1 - g) * ((1 - f) * v(a + 1, b + 1) + f * v(a + 2, b + 1)) +
                    g * ((1 - f) * v(a + 1, b + 2) + f * v(a + 2, b + 2));
            }
        }
        CHECK(power(coarse, v) == Approx(power(fine, interpolated)).epsilon(1e-12));
    }
}

TEST_CASE("axes of any length are halved down to two cells") {
    for (const int nodes : {2, 3, 4, 5, 6, 17, 18, 200}) {
        const AxisCoarsening axis(nodes);
        CHECK(axis.fine_node(0) == 0);
        CHECK(axis.fine_node(axis.coarse - 1) == nodes - 1);
        CHECK(axis.keeps_all() == (nodes <= 3));
        for (int n = 0; n < nodes; ++n) {
            const int cell = axis.cell_of(n);
            const double at =
                axis.fine_node(cell) +
                axis.fraction(n, cell) * (axis.fine_node(cell + 1) - axis.fine_node(cell));
            CHECK(at == n);
        }
    }
}

TEST_CASE("elements give every node of a flat grid its own place, however it was displaced") {
    const Extent extent{17, 13, 1};
    const PointField points = shapes::sample(extent, [](double xi, double eta, double) {
        const auto inside = [](double a) { return a > 0.01 && a < 0.99 ? 1.0 : 0.0; };
        // To and fro in turn, and leaning out of the plane z = 0.
        const double off = 0.3 * inside(xi) * inside(eta) * std::sin(8.5 * std::acos(-1.0) * xi) *
                           std::cos(5 * std::acos(-1.0) * eta) / 16;
        const Vec3 p{xi + off, eta * eta, 0};
        return Vec3{p.x, 0.8 * p.y, 0.6 * p.y};
    });
    Field values = points.x;
    for (int j = 1; j < extent.nj - 1; ++j) {
        for (int i = 1; i < extent.ni - 1; ++i) values(i, j) = 0.5;
    }
    const LaplaceResult result = solve_laplace(LaplaceHierarchy(element_conductances(points)),
                                               {true, true, true, true}, {1e-12, 50}, values);
    REQUIRE(result.converged);
    double error = 0;
    for (std::size_t n = 0; n < extent.nodes(); ++n) {
        error = std::max(error, std::abs(values[n] - points.x[n]));
    }
    CHECK(error < 1e-12);
}

}  // namespace hexweave
