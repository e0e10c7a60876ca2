// SPDX-License-Identifier: Apache-2.0
// Faces over several surfaces: the same as on one surface of that shape, and smooth where the
// surfaces meet.
#include "faces/patched_face.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include "elliptic/fold_count.h"
#include "faces/face_grid.h"
#include "faces/hand_built.h"
#include "faces/straight_line_map.h"
#include "faces/surface_face.h"

using namespace hexweave;
using namespace hexweave::test;
using std::numbers::pi;

namespace {

using Surfaces = std::vector<std::shared_ptr<const Surface>>;
using Shape = std::function<Vec3(double, double)>;

std::shared_ptr<const Surface> shared(Surface surface) {
    return std::make_shared<const Surface>(std::move(surface));
}

/// A wavy shape over the plane.
Vec3 wave(double x, double y) {
    return {x, y, 0.15 * std::sin(2 * x + 1) * std::cos(3 * y)};
}

/// `shape` over x from -0.5 to 1.5, cut along the slanting line x = cut + 0.3 (y - 0.5), its halves
/// parametrized each in its own way. `beyond`: how far the second reaches over the cut.
Surfaces in_two(const Shape& shape, double cut, double beyond = 0) {
    const auto border = [cut](double y) { return cut + 0.3 * (y - 0.5); };
    const auto left = [=](double u, double v) {
        const double y = -0.5 + 2 * v;
        const double f = u + 0.2 * u * (1 - u);
        return shape(-0.5 + f * (border(y) + 0.5), y);
    };
    const auto right = [=](double u, double v) {
        const double y = 1.5 - 2 * (u + 0.1 * std::sin(pi * u) * std::sin(pi * v));
        const double from = border(y) - beyond;
        return shape(from + v * v * v * (1.5 - from) / 2 + v * (1.5 - from) / 2, y);
    };
    return {shared(formula_surface(left, {0, 1}, {0, 1})),
            shared(formula_surface(right, {0, 1}, {0, 1}))};
}

/// A square of the plane, `turned`, whose image by a shape is a face.
HandBuilt square(const Shape& shape, int n, double turned = 0.4,
                 const std::function<double(double)>& law = identity_law) {
    HandBuilt built;
    built.law = law;
    built.method = Method::elliptic;
    const double c = std::cos(turned);
    const double s = std::sin(turned);
    built.shape = [shape, c, s](const Vec3& p) {
        const double x = p.x - 0.5;
        const double y = p.y - 0.5;
        return shape(0.5 + c * x - s * y, 0.5 + s * x + c * y);
    };
    const int a = built.vertex({0, 0, 0}), b = built.vertex({1, 0, 0});
    const int d = built.vertex({1, 1, 0}), e = built.vertex({0, 1, 0});
    built.quadrilateral({a, b, d, e}, n, n + 2);
    built.topology.faces[0].solve.tolerance = 1e-7;
    built.topology.planar = false;
    return built;
}

FaceGrid made_on(HandBuilt built, const Surfaces& surfaces) {
    Face& face = built.topology.faces[0];
    if (surfaces.size() == 1) face.surface = surfaces.front();
    if (surfaces.size() > 1) face.patches = surfaces;
    return make_faces(built.topology, built.edges).front();
}

Surfaces whole(const Shape& shape) {
    return {shared(formula_surface(shape, {-0.5, 1.5}, {-0.5, 1.5}))};
}

double farthest_off(const PointField& points, const Shape& shape) {
    double farthest = 0;
    for (std::size_t n = 0; n < points.extent().nodes(); ++n) {
        const Vec3 p = points[n];
        farthest = std::max(farthest, distance(p, shape(p.x, p.y)));
    }
    return farthest;
}

}  // namespace

TEST_CASE("a face over two surfaces is the one on a single surface of their shape") {
    for (const int n : {8, 16, 32}) {
        const HandBuilt built = square(wave, n, 0.4, clustered(0.3));
        const FaceGrid one = made_on(built, whole(wave));
        REQUIRE(one.solve.status == SolveStatus::converged);
        for (const double cut : {0.3, 0.5, 0.61}) {
            const FaceGrid two = made_on(built, in_two(wave, cut));
            REQUIRE(two.solve.status == SolveStatus::converged);
            CHECK(two.solve.folded_after == 0);
            CHECK(greatest_distance(one.points, two.points) < 1e-6 / n);
            CHECK(farthest_off(two.points, wave) < 1e-13);
        }
    }
}

TEST_CASE("where one surface ends and the next begins does not matter when they overlap") {
    const HandBuilt built = square(wave, 16);
    const FaceGrid one = made_on(built, whole(wave));
    for (const double beyond : {0.01, 0.1, 0.4}) {
        const FaceGrid two = made_on(built, in_two(wave, 0.5, beyond));
        REQUIRE(two.solve.status == SolveStatus::converged);
        CHECK(greatest_distance(one.points, two.points) < 1e-6 / 16);
        CHECK(farthest_off(two.points, wave) < 1e-13);
    }
}

TEST_CASE("a plane split in two gives a uniform grid of a square") {
    const Shape flat = [](double x, double y) { return Vec3{x, y, 0}; };
    const FaceGrid grid = made_on(square(flat, 12, 0), in_two(flat, 0.47));
    for (int j = 0; j <= 14; ++j) {
        for (int i = 0; i <= 12; ++i) {
            CHECK(distance(grid.points(i, j), {i / 12.0, j / 14.0, 0}) < 1e-8);
        }
    }
}

TEST_CASE("a face over two halves of a ball does not see their seam") {
    const auto gore = [](double from, double to) {
        return shared(formula_surface(
            [](double u, double v) {
                return Vec3{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
            },
            {from, to}, {-pi / 2, pi / 2}));
    };
    const auto ball = [](double x, double y) {
        const Vec3 p{1, x - 0.3, y - 0.4};
        return p / norm(p);
    };
    const HandBuilt built = square(ball, 20, 0.3);
    const FaceGrid one = made_on(built, {shared(sphere({0, 0, 0}, 1, {0, 1, 0}))});
    const FaceGrid two = made_on(built, {gore(0, pi), gore(pi, 2 * pi)});
    REQUIRE(two.solve.status == SolveStatus::converged);
    CHECK(greatest_distance(one.points, two.points) < 1e-6 / 20);
    double worst = 0;
    for (std::size_t n = 0; n < two.points.extent().nodes(); ++n) {
        worst = std::max(worst, std::abs(norm(two.points[n]) - 1));
    }
    CHECK(worst < 1e-14);
    // No kink in grid lines, no jump of cells: as on the single surface.
    const Extent e = two.points.extent();
    for (int j = 1; j < e.nj - 1; ++j) {
        for (int i = 1; i < e.ni - 1; ++i) {
            const Vec3 before = two.points(i, j) - two.points(i - 1, j);
            const Vec3 behind = two.points(i + 1, j) - two.points(i, j);
            CHECK(norm(behind) / norm(before) == Approx(1).epsilon(0.08));
            CHECK(dot(before, behind) / norm(before) / norm(behind) > std::cos(0.12));
        }
    }
}

TEST_CASE("a face over two surfaces does not depend on where it begins") {
    HandBuilt built = square(wave, 16);
    const FaceGrid one = made_on(built, in_two(wave, 0.5));
    built.topology.faces[0].solve.start_folded = true;
    const FaceGrid other = made_on(built, in_two(wave, 0.5));
    REQUIRE(other.solve.status == SolveStatus::converged);
    CHECK(other.solve.folded_before > 0);
    CHECK(other.solve.folded_after == 0);
    CHECK(greatest_distance(one.points, other.points) < 1e-6 / 16);
}

TEST_CASE("lines of a face over two surfaces meet a side at right angles where asked") {
    const auto slant_of = [](const PointField& points) {
        double worst = 0;
        for (int i = 4; i < points.extent().ni - 4; ++i) {
            const Vec3 up = 2 * points(i, 1) - 1.5 * points(i, 0) - 0.5 * points(i, 2);
            const Vec3 along = points(i + 1, 0) - points(i - 1, 0);
            worst = std::max(worst, std::abs(dot(up, along)) / norm(up) / norm(along));
        }
        return worst;
    };
    HandBuilt built = square(wave, 32, 0.4, clustered(0.3));
    const double before = slant_of(made_on(built, in_two(wave, 0.5)).points);
    built.topology.faces[0].orthogonal = {false, false, true, true};
    const FaceGrid upright = made_on(built, in_two(wave, 0.5));
    REQUIRE(upright.solve.orthogonality);
    CHECK(upright.solve.orthogonality->end == OrthogonalityEnd::all_passes);
    CHECK(before > 0.02);
    CHECK(slant_of(upright.points) < 0.1 * before);
    CHECK(farthest_off(upright.points, wave) < 1e-13);
    const FaceGrid one = made_on(built, whole(wave));
    CHECK(greatest_distance(one.points, upright.points) < 1e-5 / 32);
}

TEST_CASE("where two surfaces gape, points are on one of them and edges within the gap") {
    const double gap = 1e-4;
    const Surfaces two = in_two(wave, 0.5);
    const Surfaces gaping{two[0], shared(transformed(*two[1], translation({0, 0, gap})))};
    const FaceGrid grid = made_on(square(wave, 16), gaping);
    REQUIRE(grid.off_surface);
    CHECK(grid.off_surface->distance <= gap);
    CHECK(grid.off_surface->distance > 0.5 * gap);
    CHECK(grid.solve.folded_after == 0);
    const Extent e = grid.points.extent();
    for (int j = 1; j < e.nj - 1; ++j) {
        for (int i = 1; i < e.ni - 1; ++i) {
            const Vec3 p = grid.points(i, j);
            const double above = p.z - wave(p.x, p.y).z;
            CHECK(std::min(std::abs(above), std::abs(above - gap)) < 1e-13);
        }
    }
}

TEST_CASE("folded cells of a face on surfaces are untangled, and the points stay on them") {
    for (const Surfaces& surfaces : {whole(wave), in_two(wave, 0.5)}) {
        HandBuilt built = square(wave, 12, 0.4);
        Face& face = built.topology.faces[0];
        if (surfaces.size() == 1) face.surface = surfaces.front();
        if (surfaces.size() > 1) face.patches = surfaces;
        PointField points = made_on(built, surfaces).points;
        const ParameterField parameters = straight_line_map(points);
        const auto check = [&](const BoundFace& bound) {
            // Nodes exchanged with their neighbours.
            PointField folded = points;
            for (const auto& [i, j] : {std::array{4, 5}, std::array{8, 9}}) {
                folded.set(i, j, 0, points(i + 1, j));
                folded.set(i + 1, j, 0, points(i, j));
            }
            bound.project(folded);
            REQUIRE(count_folded(folded) > 0);
            const auto record = untangle_bound(folded, parameters, bound);
            REQUIRE(record);
            CHECK(record->folded_before > 0);
            CHECK(record->points_moved > 0);
            CHECK_FALSE(record->left_at);
            CHECK(count_folded(folded) == 0);
            CHECK(farthest_off(folded, wave) < 1e-13);
        };
        if (surfaces.size() > 1) {
            PatchedFace patched(surfaces, points, parameters);
            check(patched.bound());
        } else {
            SurfaceFace on_surface(*surfaces.front(), points, parameters);
            check(on_surface.bound());
        }
    }
}
