// SPDX-License-Identifier: Apache-2.0
#include "faces/face_grid.h"

#include <catch2/catch.hpp>
#include <cmath>

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
