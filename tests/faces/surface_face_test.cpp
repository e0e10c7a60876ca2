// SPDX-License-Identifier: Apache-2.0
// Faces on surfaces: on the surface, and the same however it is parametrized.
#include "faces/surface_face.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "faces/face_grid.h"
#include "faces/hand_built.h"
#include "faces/map_inverse.h"

using namespace hexweave;
using namespace hexweave::test;
using std::numbers::pi;

namespace {

/// The hill of Figs. 31 and 32, half as steep: the shape over the unit square.
Vec3 hill(double x, double y) {
    const double square = (x - 1) * (x - 1) + (y - 1) * (y - 1);
    return {x, y, std::tanh(7 * (0.25 - square)) / 8};
}

Surface hill_surface() {
    return formula_surface(hill, {0, 1}, {0, 1});
}

/// The same shape by parameters that crowd in places and lean.
Surface crowded_hill() {
    return formula_surface(
        [](double a, double b) {
            const double x = a + 0.1 * std::sin(2 * pi * a) * std::cos(pi * b);
            return hill(x, b + 0.25 * b * (1 - b) * std::sin(pi * (a + 0.3)));
        },
        {0, 1}, {0, 1});
}

/// The unit square of (x, y), its points given by `law` along edges, on a surface.
HandBuilt square_on(const Surface& surface, const std::function<Vec3(const Vec3&)>& shape, int n,
                    const std::function<double(double)>& law = identity_law) {
    HandBuilt built;
    built.shape = shape;
    built.law = law;
    built.method = Method::elliptic;
    const int a = built.vertex({0, 0, 0}), b = built.vertex({1, 0, 0});
    const int c = built.vertex({1, 1, 0}), d = built.vertex({0, 1, 0});
    built.quadrilateral({a, b, c, d}, n, n + 2);
    Face& face = built.topology.faces[0];
    face.surface = std::make_shared<const Surface>(surface);
    face.solve.tolerance = 1e-7;
    built.topology.planar = false;
    return built;
}

Vec3 on_hill(const Vec3& p) {
    return hill(p.x, p.y);
}

FaceGrid made(const HandBuilt& built) {
    return make_faces(built.topology, built.edges).front();
}

double mean_cell(int n) {
    return 1.0 / n;
}

}  // namespace

TEST_CASE("an elliptic face on a surface has every point on it and its edges to the bit") {
    const HandBuilt built = square_on(hill_surface(), on_hill, 20, clustered(0.2));
    for (const Method method : {Method::elliptic, Method::algebraic}) {
        HandBuilt asked = built;
        asked.topology.faces[0].solve.method = method;
        const FaceGrid grid = made(asked);
        const Extent e = grid.points.extent();
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) {
                const Vec3 p = grid.points(i, j);
                CHECK(std::abs(p.z - hill(p.x, p.y).z) < 1e-15);
            }
            CHECK(grid.points(0, j) == on_hill({0, built.law(j / 22.0), 0}));
        }
        CHECK(grid.solve.folded_after == 0);
        CHECK(grid.solve.status ==
              (method == Method::elliptic ? SolveStatus::converged : SolveStatus::algebraic));
    }
}

TEST_CASE("an elliptic face depends on the shape of its surface, not on the parametrization") {
    for (const int n : {10, 20, 40}) {
        const FaceGrid one = made(square_on(hill_surface(), on_hill, n, clustered(0.5)));
        const FaceGrid other = made(square_on(crowded_hill(), on_hill, n, clustered(0.5)));
        REQUIRE(one.solve.status == SolveStatus::converged);
        REQUIRE(other.solve.status == SolveStatus::converged);
        CHECK(greatest_distance(one.points, other.points) < 1e-6 * mean_cell(n));
        // The algebraic grids of the two differ by whole cells.
        HandBuilt algebraic = square_on(crowded_hill(), on_hill, n, clustered(0.5));
        algebraic.topology.faces[0].solve.method = Method::algebraic;
        CHECK(greatest_distance(made(algebraic).points, one.points) > 0.03);
    }
}

TEST_CASE(
    "a face on a sphere is the same across the seam, beside a pole and with a pole as corner") {
    const auto on_ball = [](const Vec3& p) {
        const Vec3 from_centre{p.x - 0.3, p.y - 0.4, 0.7};
        return from_centre / norm(from_centre);
    };
    const Vec3 corner = on_ball({1, 1, 0});
    const auto face_of = [&](const Surface& ball) {
        const FaceGrid grid = made(square_on(ball, on_ball, 16, clustered(0.4)));
        CHECK(grid.solve.status == SolveStatus::converged);
        return grid.points;
    };
    const PointField known = face_of(sphere({0, 0, 0}, 1, {1, -1, 0}));
    for (std::size_t n = 0; n < known.extent().nodes(); ++n) {
        CHECK(norm(known[n]) == Approx(1).epsilon(1e-15));
    }
    for (const double turn : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
        const Affine turned = rotation({1, -1, 0}, turn);
        const Surface ball = transformed(sphere({0, 0, 0}, 1, {1, -1, 0}), turned);
        CHECK(greatest_distance(face_of(ball), known) < 1e-6 * mean_cell(16));
    }
    for (const Vec3& axis : {corner, Vec3{0.8, 0.5, 0.3}}) {
        CHECK(greatest_distance(face_of(sphere({0, 0, 0}, 1, axis)), known) < 1e-6 * mean_cell(16));
    }
}

TEST_CASE("an elliptic face on a surface does not depend on where it begins") {
    HandBuilt built = square_on(crowded_hill(), on_hill, 16);
    const FaceGrid one = made(built);
    built.topology.faces[0].solve.start_folded = true;
    const FaceGrid other = made(built);
    REQUIRE(other.solve.status == SolveStatus::converged);
    CHECK(other.solve.folded_after == 0);
    CHECK(greatest_distance(one.points, other.points) < 1e-6 * mean_cell(16));
}

TEST_CASE("an elliptic face on a plane is the planar one to second order") {
    const auto bent = [](const Vec3& p) {
        // Corners stay right: elsewhere harmonic functions are not smooth there.
        const auto wave = [](double a) { return std::sin(pi * a) * std::sin(pi * a); };
        return Vec3{p.x + 0.1 * wave(p.y), p.y + 0.1 * wave(2 * p.x), 0};
    };
    const Surface plane = plane_surface({-1, -1, 0}, {3, 0, 0}, {1, 3, 0});
    std::vector<double> differences;
    for (const int n : {16, 32, 64}) {
        HandBuilt built = square_on(plane, bent, n);
        const FaceGrid on_surface = made(built);
        REQUIRE(on_surface.solve.status == SolveStatus::converged);
        built.topology.faces[0].surface = nullptr;
        built.topology.planar = true;
        differences.push_back(greatest_distance(on_surface.points, made(built).points));
    }
    CHECK(differences[0] > 1e-5);
    CHECK(differences[1] < 0.3 * differences[0]);
    CHECK(differences[2] < 0.3 * differences[1]);
}

TEST_CASE("a face round a tube, cut open along an edge, is uniform") {
    constexpr int around = 24;
    constexpr int along = 6;
    HandBuilt built;
    const auto circle_points = [](double z) {
        std::vector<Vec3> points;
        for (int n = 0; n <= around; ++n) {
            const double angle = 1 + 2 * pi * n / around;
            points.push_back({std::cos(angle), std::sin(angle), z});
        }
        return points;
    };
    const int a = built.vertex(circle_points(0).front());
    const int b = built.vertex(circle_points(2).front());
    const EdgeUse low{built.edge(a, a, circle_points(0)), false};
    const EdgeUse high{built.edge(b, b, circle_points(2)), false};
    const EdgeUse cut{built.edge(a, b, along), false};
    built.method = Method::elliptic;
    built.face({{{cut}, {cut}, {low}, {high}}});
    built.topology.faces[0].surface =
        std::make_shared<const Surface>(cone({0, 0, -1}, {0, 0, 3}, 1, 1));
    built.topology.planar = false;
    const FaceGrid grid = made(built);
    CHECK(grid.solve.status == SolveStatus::converged);
    for (int j = 0; j <= along; ++j) {
        for (int i = 0; i <= around; ++i) {
            const double angle = 1 + 2 * pi * i / around;
            CHECK(distance(grid.points(i, j), {std::cos(angle), std::sin(angle), 2.0 * j / along}) <
                  1e-4);
        }
    }
}

TEST_CASE("lines of a face on a surface meet a side at right angles where asked") {
    const auto slant_of = [](const FaceGrid& grid) {
        const Extent e = grid.points.extent();
        double worst = 0;
        for (int i = 4; i < e.ni - 4; ++i) {
            const Vec3 up =
                2 * grid.points(i, 1) - 1.5 * grid.points(i, 0) - 0.5 * grid.points(i, 2);
            const Vec3 along = grid.points(i + 1, 0) - grid.points(i - 1, 0);
            worst = std::max(worst, std::abs(dot(up, along)) / norm(up) / norm(along));
        }
        return worst;
    };
    HandBuilt built = square_on(hill_surface(), on_hill, 32, clustered(0.3));
    const double before = slant_of(made(built));
    built.topology.faces[0].orthogonal = {false, false, false, true};
    built.topology.faces[0].orthogonal[2] = true;
    const FaceGrid upright = made(built);
    REQUIRE(upright.solve.orthogonality);
    CHECK(upright.solve.orthogonality->end == OrthogonalityEnd::all_passes);
    CHECK(before > 0.02);
    CHECK(slant_of(upright) < 0.1 * before);
    for (std::size_t n = 0; n < upright.points.extent().nodes(); ++n) {
        const Vec3 p = upright.points[n];
        CHECK(std::abs(p.z - hill(p.x, p.y).z) < 1e-15);
    }
}

TEST_CASE("heights held on a face on a surface leave its points on the surface") {
    HandBuilt built = square_on(hill_surface(), on_hill, 20);
    HeldHeights held;
    held.height = 0.035;
    held.fade = 0.5;
    built.topology.faces[0].solve.heights[static_cast<std::size_t>(Side::jmin)] = held;
    const FaceGrid grid = made(built);
    REQUIRE(grid.heights.size() == 1);
    for (std::size_t n = 0; n < grid.points.extent().nodes(); ++n) {
        const Vec3 p = grid.points[n];
        CHECK(std::abs(p.z - hill(p.x, p.y).z) < 1e-13);
    }
    CHECK(distance(grid.points(10, 0), grid.points(10, 1)) == Approx(0.035).epsilon(0.01));
}

TEST_CASE("the place of a value in a map is found from anywhere, in thin cells too") {
    const Extent e{9, 13, 1};
    Field s(e);
    Field t(e);
    for (int j = 0; j < e.nj; ++j) {
        for (int i = 0; i < e.ni; ++i) {
            const double f = i / 8.0;
            const double g = std::pow(j / 12.0, 6);  // the first row is 3e-7 high
            s(i, j) = f + 0.3 * f * (1 - f) * std::sin(3 * g);
            t(i, j) = g * (1 + 0.2 * (1 - g) * f);
        }
    }
    for (int j = 0; j < e.nj - 1; ++j) {
        for (int i = 0; i < e.ni - 1; ++i) {
            const CellPlace known{i, j, 0.3, 0.8};
            const SquarePoint value{known.of(s), known.of(t)};
            for (const CellPlace& start : {CellPlace{0, 0}, CellPlace{7, 11}, CellPlace{7, 0}}) {
                const CellPlace found = place_of(s, t, value, start);
                CHECK(found.i == i);
                CHECK(found.j == j);
                CHECK(found.alpha == Approx(0.3).margin(1e-9));
                CHECK(found.beta == Approx(0.8).margin(1e-9));
            }
        }
    }
}
