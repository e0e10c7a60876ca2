// SPDX-License-Identifier: Apache-2.0
// Solved grids against exact ones: the error falls with second order.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "elliptic/elliptic_solver.h"
#include "elliptic/shapes.h"

namespace hexweave {
namespace {

constexpr EllipticOptions tight{1e-6, 200};

/// The largest distance of the solved grid from the map that gave its boundary, n cells per axis;
/// the interior starts from nothing.
double error_of_solution(int n, int axes, const shapes::Map& map, const shapes::Map& parameters) {
    const Extent e{n + 1, n + 1, axes == 3 ? n + 1 : 1};
    const PointField exact = shapes::sample(e, map);
    const ParameterField s = shapes::sample_parameters(e, parameters);
    PointField points = exact;
    shapes::interpolate(points, s);
    REQUIRE(solve_elliptic(points, s, tight).status == SolveStatus::converged);
    double error = 0;
    for (std::size_t p = 0; p < e.nodes(); ++p)
        error = std::max(error, distance(points[p], exact[p]));
    return error;
}

Vec3 leaning_annulus(double xi, double eta, double zeta) {
    return shapes::annulus(shapes::leaning(xi, eta, zeta));
}

/// The same on lines that grow from first cells of 1e-3 of the last ones.
Vec3 clustered(double xi, double eta, double zeta) {
    return shapes::leaning(xi, std::expm1(7 * eta) / std::expm1(7.0), zeta);
}

Vec3 clustered_annulus(double xi, double eta, double zeta) {
    return shapes::annulus(clustered(xi, eta, zeta));
}

/// The same with the clustered lines along the radius.
Vec3 clustered_at_wall(double xi, double eta, double zeta) {
    const Vec3 s = clustered(eta, xi, zeta);
    return {s.y, s.x, s.z};
}

Vec3 annulus_clustered_at_wall(double xi, double eta, double zeta) {
    return shapes::annulus(clustered_at_wall(xi, eta, zeta));
}

/// Nodes of the square |x|, |y| <= 1.2 on Scherk's surface; `spread` makes opposite edges' nodes
/// unequally spaced.
PointField scherk(int n, double spread) {
    const auto stretch = [](double f, double by) { return f + by * f * (1 - f); };
    return shapes::sample({n, n, 1}, [&](double xi, double eta, double) {
        const double x = 1.2 * (2 * stretch(xi, spread * (1 - 2 * eta)) - 1);
        const double y = 1.2 * (2 * stretch(eta, spread * (0.5 - xi)) - 1);
        return Vec3{x, y, std::log(std::cos(x) / std::cos(y))};
    });
}

double distance_to_scherk(int n, double spread) {
    PointField points = scherk(n, spread);
    const ParameterField s = shapes::straight_line_parameters(points);
    shapes::interpolate(points, s);
    const SolveResult result = solve_elliptic(points, s, tight);
    REQUIRE(result.status == SolveStatus::converged);
    CHECK(result.folded_after == 0);
    double error = 0;
    for (std::size_t p = 0; p < points.extent().nodes(); ++p) {
        const Vec3 x = points[p];
        error = std::max(error, std::abs(x.z - std::log(std::cos(x.x) / std::cos(x.y))));
    }
    return error;
}

void check_second_order(double coarse, double fine) {
    INFO("errors " << coarse << ", " << fine);
    CHECK(std::log2(coarse / fine) > 1.8);
    CHECK(std::log2(coarse / fine) < 2.3);
}

}  // namespace

TEST_CASE("a planar grid converges to the exact one with second order") {
    check_second_order(error_of_solution(16, 2, leaning_annulus, shapes::leaning),
                       error_of_solution(32, 2, leaning_annulus, shapes::leaning));
}

TEST_CASE("a block converges to the exact grid with second order") {
    check_second_order(error_of_solution(10, 3, leaning_annulus, shapes::leaning),
                       error_of_solution(20, 3, leaning_annulus, shapes::leaning));
}

TEST_CASE("strongly clustered grids converge to the exact ones with second order") {
    check_second_order(error_of_solution(32, 2, clustered_annulus, clustered),
                       error_of_solution(64, 2, clustered_annulus, clustered));
    check_second_order(error_of_solution(32, 2, annulus_clustered_at_wall, clustered_at_wall),
                       error_of_solution(64, 2, annulus_clustered_at_wall, clustered_at_wall));
    check_second_order(error_of_solution(16, 3, clustered_annulus, clustered),
                       error_of_solution(32, 3, clustered_annulus, clustered));
    check_second_order(error_of_solution(16, 3, annulus_clustered_at_wall, clustered_at_wall),
                       error_of_solution(32, 3, annulus_clustered_at_wall, clustered_at_wall));
}

TEST_CASE("with parameters of another map the grid converges to another grid") {
    const auto uniform = [](double xi, double eta, double zeta) { return Vec3{xi, eta, zeta}; };
    const double coarse = error_of_solution(16, 2, leaning_annulus, uniform);
    const double fine = error_of_solution(32, 2, leaning_annulus, uniform);
    CHECK(fine > 0.9 * coarse);
}

TEST_CASE("a face spanned in space converges to the minimal surface with second order") {
    check_second_order(distance_to_scherk(17, 0), distance_to_scherk(33, 0));
    check_second_order(distance_to_scherk(33, 0), distance_to_scherk(65, 0));
}

TEST_CASE("the shape of a minimal surface does not depend on the distribution of boundary nodes") {
    check_second_order(distance_to_scherk(33, 0.6), distance_to_scherk(65, 0.6));
}

}  // namespace hexweave
