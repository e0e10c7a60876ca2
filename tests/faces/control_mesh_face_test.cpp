// SPDX-License-Identifier: Apache-2.0
// Faces on surfaces through control points: the same from any mesh of the same shape, to the
// accuracy of the interpolation.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include "faces/face_grid.h"
#include "faces/hand_built.h"
#include "geometry/control_mesh.h"

using namespace hexweave;
using namespace hexweave::test;
using std::numbers::pi;

namespace {

using PlaneMap = std::function<Vec3(double, double)>;

/// The surface of Figs. 31 and 32.
Vec3 steep(const Vec3& p) {
    const double square = (p.x - 1) * (p.x - 1) + (p.y - 1) * (p.y - 1);
    return {p.x, p.y, std::tanh(15 * (0.25 - square)) / 8};
}

Vec3 flat(const Vec3& p) {
    return {p.x, p.y, 0};
}

/// Two one-to-one maps of the unit square on itself.
Vec3 swirled(double a, double b) {
    return {a + 0.08 * std::sin(2 * pi * a) * std::cos(2 * pi * b),
            b + 0.06 * std::sin(2 * pi * b) * std::cos(3 * pi * a + 0.5), 0};
}

Vec3 leaning(double a, double b) {
    return {a + 0.25 * a * (1 - a) * std::sin(pi * (b + 0.2)),
            b + 0.1 * std::sin(2 * pi * b) * std::cos(pi * a), 0};
}

/// The surface through n + 1 by n + 1 points of a shape.
Surface through(const std::function<Vec3(const Vec3&)>& shape, const PlaneMap& map, int n) {
    ControlMesh mesh{n + 1, n + 1, {}};
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            mesh.points.push_back(
                shape(map(static_cast<double>(i) / n, static_cast<double>(j) / n)));
        }
    }
    return control_surface(mesh);
}

/// The grid of a surface over the unit square, with edges on the given shape.
FaceGrid made(const Surface& surface, const std::function<Vec3(const Vec3&)>& shape, int cells,
              Method method = Method::elliptic) {
    HandBuilt built;
    built.shape = shape;
    built.method = method;
    const int a = built.vertex({0, 0, 0});
    const int b = built.vertex({1, 0, 0});
    const int c = built.vertex({1, 1, 0});
    const int d = built.vertex({0, 1, 0});
    built.quadrilateral({a, b, c, d}, cells, cells);
    Face& face = built.topology.faces[0];
    face.surface = std::make_shared<const Surface>(surface);
    face.solve.tolerance = 1e-8;
    built.topology.planar = false;
    FaceGrid grid = make_faces(built.topology, built.edges).front();
    CHECK(grid.solve.status ==
          (method == Method::elliptic ? SolveStatus::converged : SolveStatus::algebraic));
    return grid;
}

/// How far a grid is from the uniform one of the unit square.
double off_uniform(const FaceGrid& grid) {
    const Extent e = grid.points.extent();
    double worst = 0;
    for (int j = 0; j < e.nj; ++j) {
        for (int i = 0; i < e.ni; ++i) {
            const Vec3 uniform{static_cast<double>(i) / (e.ni - 1),
                               static_cast<double>(j) / (e.nj - 1), 0};
            worst = std::max(worst, distance(grid.points(i, j), uniform));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("the elliptic grid of the unit square is uniform whatever its control points") {
    for (const PlaneMap& map : {PlaneMap(swirled), PlaneMap(leaning)}) {
        for (const int points : {8, 20}) {
            const Surface square = through(flat, map, points);
            CHECK(off_uniform(made(square, flat, 24)) < 1e-8);
            CHECK(off_uniform(made(square, flat, 24, Method::algebraic)) > 0.03);
        }
    }
}

TEST_CASE("grids from two control meshes of one shape differ by the error of interpolation") {
    std::vector<double> differences;
    for (const int n : {32, 64, 128}) {
        const Surface one = through(steep, swirled, n);
        const Surface other = through(steep, leaning, n);
        const PointField grid = made(one, steep, 24).points;
        differences.push_back(greatest_distance(grid, made(other, steep, 24).points));
        // Those that follow the parameters differ by whole cells.
        CHECK(greatest_distance(grid, made(one, steep, 24, Method::algebraic).points) > 0.03);
    }
    CHECK(differences[0] < 3e-3);
    CHECK(std::log2(differences[0] / differences[1]) > 3);
    CHECK(differences[2] < 2e-6);
    CHECK(std::log2(differences[1] / differences[2]) > 3.7);
}
