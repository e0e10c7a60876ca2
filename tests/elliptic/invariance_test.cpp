// SPDX-License-Identifier: Apache-2.0
// One grid for one boundary: whatever the start, the position in space and the naming of the axes.
// And the stopping test tells the truth about how far away that grid is.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "core/parallel.h"
#include "elliptic/cell_units.h"
#include "elliptic/elliptic_solver.h"
#include "elliptic/shapes.h"

namespace hexweave {
namespace {

constexpr EllipticOptions tight{1e-8, 300};

PointField solved(shapes::Problem problem, const EllipticOptions& options = tight) {
    REQUIRE(solve_elliptic(problem.points, problem.parameters, options).status ==
            SolveStatus::converged);
    return problem.points;
}

using NodeMap = std::function<std::array<int, 3>(int, int, int)>;

/// The same nodes under other indices: node (i, j, k) of the result is node old(i, j, k).
PointField relabelled(const PointField& points, const Extent& extent, const NodeMap& old) {
    PointField result(extent);
    for (int k = 0; k < extent.nk; ++k) {
        for (int j = 0; j < extent.nj; ++j) {
            for (int i = 0; i < extent.ni; ++i) {
                const auto n = old(i, j, k);
                result.set(i, j, k, points(n[0], n[1], n[2]));
            }
        }
    }
    return result;
}

shapes::Problem relabelled(const shapes::Problem& problem, const Extent& extent,
                           const NodeMap& old) {
    PointField s(problem.points.extent());
    s.x = problem.parameters.s;
    s.y = problem.parameters.t;
    s.z = problem.parameters.u;
    s = relabelled(s, extent, old);
    return {relabelled(problem.points, extent, old), {s.x, s.y, s.z}};
}

void map_points(PointField& points, const std::function<Vec3(const Vec3&)>& map) {
    for (std::size_t p = 0; p < points.extent().nodes(); ++p) points.set(p, map(points[p]));
}

/// A turn about no special axis, with columns of an orthonormal frame.
Vec3 turn(const Vec3& p) {
    const Vec3 a{2. / 3, 2. / 3, 1. / 3};
    const Vec3 b{-2. / 3, 1. / 3, 2. / 3};
    const Vec3 c{1. / 3, -2. / 3, 2. / 3};
    return p.x * a + p.y * b + p.z * c;
}

double true_error_in_cells(const PointField& grid, const PointField& exact) {
    const std::vector<Vec3> reference = shapes::nodes_of(exact);
    std::vector<Vec3> displacement = shapes::nodes_of(grid);
    for (std::size_t p = 0; p < reference.size(); ++p) displacement[p] -= reference[p];
    return largest_displacement(NodeLattice(exact.extent()), reference, displacement);
}

}  // namespace

TEST_CASE("the grid of a face does not depend on its start") {
    shapes::Problem problem = shapes::meander(65, 33, 1.5);
    const PointField grid = solved(problem);
    shapes::scatter(problem.points, {0, 0, 0}, {4, 2, 0});
    CHECK(shapes::difference_in_cells(problem.points, grid) > 100);
    CHECK(shapes::difference_in_cells(solved(problem), grid) < 1e-6);
}

TEST_CASE("the grid of a block does not depend on its start") {
    shapes::Problem problem = shapes::wavy_cube(17);
    const PointField grid = solved(problem);
    shapes::fold(problem);
    CHECK(shapes::difference_in_cells(problem.points, grid) > 1);
    CHECK(shapes::difference_in_cells(solved(problem), grid) < 1e-6);
    shapes::scatter(problem.points, {0, 0, 0}, {1, 1, 1});
    CHECK(shapes::difference_in_cells(solved(problem), grid) < 1e-6);
}

TEST_CASE("turning the boundary turns the grid") {
    for (shapes::Problem problem : {shapes::meander(33, 17, 1.2), shapes::wavy_cube(9)}) {
        PointField grid = solved(problem);
        map_points(grid, turn);
        map_points(problem.points, turn);
        CHECK(shapes::difference_in_cells(solved(problem), grid) < 1e-8);
    }
}

TEST_CASE("the unit of length and the origin do not matter") {
    const auto map = [](const Vec3& p) { return 1e3 * p + Vec3{500, -200, 100}; };
    shapes::Problem problem = shapes::wavy_cube(9);
    PointField grid = solved(problem);
    map_points(grid, map);
    map_points(problem.points, map);
    CHECK(shapes::difference_in_cells(solved(problem), grid) < 1e-8);
}

TEST_CASE("relabelling the axes relabels the grid") {
    const shapes::Problem face = shapes::meander(33, 17, 1.2);
    const NodeMap swap = [](int i, int j, int) { return std::array{j, i, 0}; };
    const NodeMap reverse = [](int i, int j, int) { return std::array{32 - i, j, 0}; };
    const PointField face_grid = solved(face);
    CHECK(shapes::difference_in_cells(solved(relabelled(face, {17, 33, 1}, swap)),
                                      relabelled(face_grid, {17, 33, 1}, swap)) < 1e-6);
    CHECK(shapes::difference_in_cells(solved(relabelled(face, {33, 17, 1}, reverse)),
                                      relabelled(face_grid, {33, 17, 1}, reverse)) < 1e-6);

    const shapes::Problem block = shapes::wavy_cube(9);
    const NodeMap cycle = [](int i, int j, int k) { return std::array{j, 8 - k, i}; };
    CHECK(shapes::difference_in_cells(solved(relabelled(block, {9, 9, 9}, cycle)),
                                      relabelled(solved(block), {9, 9, 9}, cycle)) < 1e-6);
}

TEST_CASE("a planar face stays in its plane to the bit") {
    shapes::Problem problem = shapes::meander(33, 17, 1.2);
    for (std::size_t p = 0; p < problem.points.extent().nodes(); ++p) problem.points.z[p] = 0.3;
    const PointField grid = solved(problem);
    for (std::size_t p = 0; p < grid.extent().nodes(); ++p) REQUIRE(grid.z[p] == 0.3);
}

TEST_CASE("the true error of a converged grid is below the tolerance") {
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
        for (const shapes::Problem& problem :
             {shapes::meander(65, 33, 1.2), shapes::meander(65, 33, 1.6), shapes::wavy_cube(13)}) {
            const double error =
                true_error_in_cells(solved(problem, {tolerance, 200}), solved(problem));
            CHECK(error < tolerance);
        }
    }
}

TEST_CASE("the same problem has the same bits every time") {
    const shapes::Problem problem = shapes::wavy_cube(9);
    const PointField first = solved(problem);
    const PointField second = solved(problem);
    for (std::size_t p = 0; p < first.extent().nodes(); ++p) REQUIRE(first[p] == second[p]);
}

TEST_CASE("a solve has the same bits on any number of threads, safeguards included") {
    const int before = threads();
    for (const shapes::Problem& problem :
         {shapes::meander(193, 97, 1.7), shapes::clustered_saddle(97, 130, 1e-4),
          shapes::clustered_block({40, 33, 38}, 1e-4), shapes::meander(65, 33, 2.1)}) {
        PointField reference;
        SolveResult told;
        for (const int count : {1, 2, 4, 7}) {
            set_threads(count);
            PointField points = problem.points;
            const SolveResult result = solve_elliptic(points, problem.parameters, {1e-4, 100});
            CHECK(result.status == SolveStatus::converged);
            if (count == 1) {
                reference = points;
                told = result;
            }
            CHECK(result.history == told.history);
            CHECK(result.safeguards == told.safeguards);
            bool same = true;
            for (std::size_t p = 0; p < points.extent().nodes(); ++p) {
                same = same && points[p] == reference[p];
            }
            CHECK(same);
        }
    }
    set_threads(before);
}

}  // namespace hexweave
