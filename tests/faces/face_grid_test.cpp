// SPDX-License-Identifier: Apache-2.0
#include "faces/face_grid.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/largest_first.h"
#include "core/parallel.h"
#include "elliptic/fold_count.h"
#include "faces/face_boundary.h"
#include "faces/hand_built.h"

using namespace hexweave;
using namespace hexweave::test;

namespace {

/// A square of side 2 whose bottom is three edges (the middle one against the side's direction) and
/// whose other sides are one edge each.
HandBuilt square_of_several_edges() {
    HandBuilt built;
    const int a = built.vertex({0, 0, 0}), b = built.vertex({0.5, 0.1, 0});
    const int c = built.vertex({1.2, -0.1, 0}), d = built.vertex({2, 0, 0});
    const int e = built.vertex({2, 2, 0}), f = built.vertex({0, 2, 0});
    built.law = clustered(0.1);
    const EdgeUse first{built.edge(a, b, 4), false};
    const EdgeUse second{built.edge(c, b, 3), true};
    const EdgeUse third{built.edge(c, d, 5), false};
    built.face({{{built.between(a, f, 6)},
                 {built.between(d, e, 6)},
                 {first, second, third},
                 {EdgeUse{built.between(e, f, 12).edge, true}}}});
    return built;
}

}  // namespace

TEST_CASE("a side of several edges holds the points of its edges, one after another") {
    const HandBuilt built = square_of_several_edges();
    const auto line = side_points(built.topology.faces[0], Side::jmin, built.edges);
    REQUIRE(line.size() == 13);
    for (std::size_t n = 0; n <= 4; ++n) CHECK(line[n] == built.edges[0].points[n]);
    for (std::size_t n = 0; n <= 3; ++n) CHECK(line[4 + n] == built.edges[1].points[3 - n]);
    for (std::size_t n = 0; n <= 5; ++n) CHECK(line[7 + n] == built.edges[2].points[n]);
}

TEST_CASE("an algebraic face has its edges' points on its boundary and z = 0 when planar") {
    const HandBuilt built = square_of_several_edges();
    int made = 0;
    const auto faces = make_faces(built.topology, built.edges, [&] { ++made; });
    CHECK(made == 1);
    REQUIRE(faces.size() == 1);
    const PointField& points = faces[0].points;
    CHECK(points.extent() == Extent{13, 7, 1});
    CHECK(faces[0].solve.status == SolveStatus::algebraic);
    const PointField boundary = face_boundary(built.topology.faces[0], built.edges);
    for (int j = 0; j < 7; ++j) {
        for (int i = 0; i < 13; ++i) {
            if (i == 0 || i == 12 || j == 0 || j == 6) CHECK(points(i, j) == boundary(i, j));
            CHECK(points(i, j).z == 0);
            CHECK_FALSE(std::signbit(points(i, j).z));
        }
    }
}

TEST_CASE("every point of a face on a symmetry plane is exactly on it") {
    HandBuilt built;
    built.shape = [](const Vec3& p) { return Vec3{p.x + 0.3 * p.z * p.z, 0.1, p.z + 0.2 * p.x}; };
    const int a = built.vertex({0, 0, 0}), b = built.vertex({1, 0, 0});
    const int c = built.vertex({1, 0, 1}), d = built.vertex({0, 0, 1});
    built.quadrilateral({a, b, c, d}, 7, 9);
    built.topology.planar = false;
    built.topology.faces[0].plane = AxisPlane{1, 0.1};
    const auto faces = make_faces(built.topology, built.edges);
    for (std::size_t n = 0; n < faces[0].points.extent().nodes(); ++n) {
        CHECK(faces[0].points[n].y == 0.1);
    }
}

TEST_CASE("faces come in the topology's order, whatever their size and the number of threads") {
    HandBuilt built;
    for (int n = 0; n < 5; ++n) {
        const double x = 2.0 * n;
        const int a = built.vertex({x, 0, 0}), b = built.vertex({x + 1, 0, 0});
        const int c = built.vertex({x + 1, 1, 0}), d = built.vertex({x, 1, 0});
        built.quadrilateral({a, b, c, d}, 3 + 4 * (n * n % 5), 5);
    }
    int made = 0;
    const auto faces = make_faces(built.topology, built.edges, [&] { ++made; });
    CHECK(made == 5);
    for (std::size_t n = 0; n < 5; ++n) {
        CHECK(faces[n].points.extent() == built.topology.faces[n].extent());
        CHECK(faces[n].points(0, 0).x == 2.0 * static_cast<double>(n));
    }
}

namespace {

/// A square whose bottom is a wave with overhangs, and clustered towards it: transfinite
/// interpolation folds.
HandBuilt wavy_square() {
    HandBuilt built;
    built.method = Method::elliptic;
    const int a = built.vertex({0, 0, 0}), b = built.vertex({1, 0, 0});
    const int c = built.vertex({1, 1, 0}), d = built.vertex({0, 1, 0});
    std::vector<Vec3> wave;
    for (int n = 0; n <= 48; ++n) {
        const double u = n / 48.0;
        const double shift = 0.06 * std::sin(std::numbers::pi * u);
        wave.push_back({u - shift * std::sin(8 * std::numbers::pi * u),
                        0.25 * std::sin(4 * std::numbers::pi * u), 0});
    }
    built.edge(a, b, wave);
    built.law = clustered(0.02);
    built.between(a, d, 24);
    built.between(b, c, 24);
    built.law = identity_law;
    built.quadrilateral({a, b, c, d}, 48, 24);
    return built;
}

}  // namespace

TEST_CASE("an elliptic face is sound where its start grid is folded, and planar stays planar") {
    const HandBuilt built = wavy_square();
    const auto faces = make_faces(built.topology, built.edges);
    const SolveResult& solve = faces[0].solve;
    CHECK(solve.status == SolveStatus::converged);
    CHECK(solve.folded_before > 50);
    CHECK(solve.folded_after == 0);
    const PointField boundary = face_boundary(built.topology.faces[0], built.edges);
    for (int j = 0; j <= 24; ++j) {
        for (int i = 0; i <= 48; ++i) {
            if (i == 0 || i == 48 || j == 0 || j == 24) {
                CHECK(faces[0].points(i, j) == boundary(i, j));
            }
            CHECK(faces[0].points(i, j).z == 0);
            CHECK_FALSE(std::signbit(faces[0].points(i, j).z));
        }
    }
}

TEST_CASE("an elliptic face does not depend on its start grid") {
    HandBuilt built = wavy_square();
    built.topology.faces[0].solve.tolerance = 1e-8;
    const auto plain = make_faces(built.topology, built.edges);
    built.topology.faces[0].solve.start_folded = true;
    const auto folded = make_faces(built.topology, built.edges);
    CHECK(plain[0].solve.status == SolveStatus::converged);
    CHECK(folded[0].solve.status == SolveStatus::converged);
    CHECK(folded[0].solve.folded_before > plain[0].solve.folded_before + 100);
    // The smallest cells are about 1 / 24 * 0.02 high.
    CHECK(greatest_distance(plain[0].points, folded[0].points) < 1e-6 * 0.02 / 24);
}

TEST_CASE("turning a face by a right angle turns its elliptic grid") {
    const HandBuilt built = wavy_square();
    HandBuilt turned = wavy_square();
    Face& face = turned.topology.faces[0];
    face.solve.tolerance = 1e-9;
    // i' = j, j' = reversed i.
    const auto reversed = [](std::vector<EdgeUse> side) {
        for (EdgeUse& use : side) use.reversed = !use.reversed;
        return side;
    };
    std::swap(face.cells_i, face.cells_j);
    face.sides = {reversed(built.topology.faces[0].sides[2]),
                  reversed(built.topology.faces[0].sides[3]), built.topology.faces[0].sides[1],
                  built.topology.faces[0].sides[0]};
    HandBuilt plain = wavy_square();
    plain.topology.faces[0].solve.tolerance = 1e-9;
    const auto one = make_faces(plain.topology, plain.edges);
    const auto two = make_faces(turned.topology, turned.edges);
    REQUIRE(two[0].solve.status == SolveStatus::converged);
    for (int j = 0; j <= 24; ++j) {
        for (int i = 0; i <= 48; ++i) {
            CHECK(distance(one[0].points(i, j), two[0].points(j, 48 - i)) < 1e-10);
        }
    }
}

TEST_CASE("counts of folded cells are those of the finished points") {
    HandBuilt built = wavy_square();
    built.topology.faces[0].solve.method = Method::algebraic;
    const FaceGrid algebraic = make_faces(built.topology, built.edges)[0];
    CHECK(algebraic.solve.status == SolveStatus::algebraic);
    CHECK(algebraic.solve.folded_after > 50);
    CHECK(algebraic.solve.folded_before == algebraic.solve.folded_after);
    CHECK(algebraic.solve.folded_after == count_folded(algebraic.points));

    built.topology.faces[0].solve.heights[static_cast<std::size_t>(Side::jmin)] =
        HeldHeights{0.0005, 0.3, 1.5};
    const FaceGrid held = make_faces(built.topology, built.edges)[0];
    CHECK(held.solve.folded_before == algebraic.solve.folded_after);
    CHECK(held.solve.folded_after == count_folded(held.points));
    CHECK(greatest_distance(held.points, algebraic.points) > 0);
}

TEST_CASE("several faces have the same bits on any number of threads") {
    HandBuilt built;
    built.method = Method::elliptic;
    built.shape = [](const Vec3& p) {
        return Vec3{p.x + 0.05 * std::sin(7 * p.y), p.y + 0.05 * std::sin(5 * p.x), 0};
    };
    std::vector<std::array<int, 2>> columns;
    for (const double x : {0.0, 2.0, 2.3, 2.6, 3.0}) {
        columns.push_back({built.vertex({x, 0, 0}), built.vertex({x, 1, 0})});
    }
    built.law = clustered(0.01);
    const std::array<int, 4> cells{220, 20, 30, 10};
    for (std::size_t n = 0; n < 4; ++n) {
        built.quadrilateral({columns[n][0], columns[n + 1][0], columns[n + 1][1], columns[n][1]},
                            cells[n], 100);
    }
    REQUIRE(built.topology.faces[0].extent().nodes() > worth_all_threads);
    const int before = threads();
    std::vector<FaceGrid> of_one;
    for (const int count : {1, 2, 4, 7}) {
        set_threads(count);
        auto faces = make_faces(built.topology, built.edges);
        if (count == 1) of_one = faces;
        for (std::size_t n = 0; n < faces.size(); ++n) {
            CHECK(faces[n].solve.status == SolveStatus::converged);
            CHECK(faces[n].solve.history == of_one[n].solve.history);
            CHECK(greatest_distance(faces[n].points, of_one[n].points) == 0);
        }
    }
    set_threads(before);
}

TEST_CASE("a face of nine nodes whose start is exact is converged") {
    HandBuilt built;
    built.method = Method::elliptic;
    const int a = built.vertex({0.1, 0.2, 0}), b = built.vertex({1.3, 0.2, 0});
    const int c = built.vertex({1.3, 0.9, 0}), d = built.vertex({0.1, 0.9, 0});
    built.quadrilateral({a, b, c, d}, 2, 2);
    const FaceGrid face = make_faces(built.topology, built.edges)[0];
    CHECK(face.solve.status == SolveStatus::converged);
    CHECK(distance(face.points(1, 1), {0.7, 0.55, 0}) < 1e-15);
}
