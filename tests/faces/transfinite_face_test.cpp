// SPDX-License-Identifier: Apache-2.0
#include "faces/transfinite_face.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "faces/folded_start.h"
#include "faces/hand_built.h"
#include "faces/straight_line_map.h"

using namespace hexweave;
using namespace hexweave::test;

namespace {

using Law = std::function<double(double)>;
using Map = std::function<Vec3(double, double)>;

/// A face whose boundary is the image of the unit square's, with a law on each side (imin, imax,
/// jmin, jmax); the interior is not set.
PointField boundary_of(const Map& map, const std::array<Law, 4>& laws, int ni, int nj) {
    PointField points(Extent{ni, nj, 1});
    for (int i = 0; i < ni; ++i) {
        const double u = static_cast<double>(i) / (ni - 1);
        points.set(i, 0, 0, map(laws[2](u), 0));
        points.set(i, nj - 1, 0, map(laws[3](u), 1));
    }
    for (int j = 0; j < nj; ++j) {
        const double v = static_cast<double>(j) / (nj - 1);
        points.set(0, j, 0, map(0, laws[0](v)));
        points.set(ni - 1, j, 0, map(1, laws[1](v)));
    }
    return points;
}

void check_same_boundary(const PointField& a, const PointField& b) {
    const Extent e = a.extent();
    for (int j = 0; j < e.nj; ++j) {
        for (int i = 0; i < e.ni; ++i) {
            if (i > 0 && i < e.ni - 1 && j > 0 && j < e.nj - 1) continue;
            REQUIRE(a(i, j) == b(i, j));
        }
    }
}

Vec3 bilinear(double s, double t) {
    return lerp(lerp(Vec3{0, 0, 1}, Vec3{3, 1, 0}, s), lerp(Vec3{-1, 2, 0}, Vec3{2, 2.5, 4}, s), t);
}

PointField relabelled(const PointField& points, const Orientation& o) {
    PointField result(own_extent(o, points.extent()));
    const Extent e = result.extent();
    for (int j = 0; j < e.nj; ++j) {
        for (int i = 0; i < e.ni; ++i) {
            const Node n = map_node(o, {i, j, 0}, points.extent());
            result.set(i, j, 0, points(n[0], n[1], n[2]));
        }
    }
    return result;
}

long folded_cells(const PointField& points) {
    long folded = 0;
    for (int j = 0; j + 1 < points.extent().nj; ++j) {
        for (int i = 0; i + 1 < points.extent().ni; ++i) {
            const Vec3 a = points(i + 1, j + 1) - points(i, j);
            const Vec3 b = points(i, j + 1) - points(i + 1, j);
            folded += cross(a, b).z <= 0;
        }
    }
    return folded;
}

Vec3 wavy(double s, double t) {
    return {s + 0.1 * std::sin(5 * t), t + 0.2 * std::sin(4 * s) + 0.1 * s * t, s * s - t};
}

}  // namespace

TEST_CASE("transfinite interpolation of a face keeps its boundary to the bit") {
    const PointField boundary =
        boundary_of(wavy, {clustered(1e-3), clustered(0.3), identity_law, clustered(0.1)}, 9, 7);
    PointField points = boundary;
    interpolate_face(points, straight_line_map(points));
    check_same_boundary(points, boundary);
}

TEST_CASE("transfinite interpolation of a face is exact for bilinear maps with any four laws") {
    const std::array<Law, 4> laws{clustered(1e-3), clustered(0.3), identity_law, clustered(1e-5)};
    PointField points = boundary_of(bilinear, laws, 12, 9);
    const ParameterField p = straight_line_map(points);
    interpolate_face(points, p);
    for (std::size_t n = 0; n < points.extent().nodes(); ++n) {
        CHECK(distance(points[n], bilinear(p.s[n], p.t[n])) < 4e-15);
    }
}

TEST_CASE("with equal laws transfinite interpolation is the Boolean sum of Gordon and Hall") {
    // The exact Boolean sum of this map is known: it loses only the term s (1 - s) t (1 - t).
    const auto map = [](double s, double t) {
        return Vec3{s + 0.3 * s * t, t, s * s * (1 + t) + t * t * (2 - s)};
    };
    PointField points =
        boundary_of(map, {identity_law, identity_law, identity_law, identity_law}, 11, 11);
    ParameterField uniform{Field(points.extent()), Field(points.extent()), {}};
    for (int j = 0; j < 11; ++j) {
        for (int i = 0; i < 11; ++i) {
            uniform.s(i, j) = i / 10.0;
            uniform.t(i, j) = j / 10.0;
        }
    }
    interpolate_face(points, uniform);
    for (int j = 0; j < 11; ++j) {
        for (int i = 0; i < 11; ++i) {
            CHECK(distance(points(i, j), map(i / 10.0, j / 10.0)) < 1e-15);
        }
    }
}

TEST_CASE("transfinite interpolation is exact on a cone between two circular arcs") {
    const auto cone = [](double s, double t) {
        const double angle = 0.5 * std::numbers::pi * s;
        const double radius = 2 - t;
        return Vec3{radius * std::cos(angle), radius * std::sin(angle), 5 * t};
    };
    PointField points =
        boundary_of(cone, {clustered(1e-4), clustered(1e-4), identity_law, identity_law}, 33, 20);
    interpolate_face(points, straight_line_map(points));
    for (int j = 0; j < 20; ++j) {
        for (int i = 0; i < 33; ++i) {
            const Vec3 p = points(i, j);
            CHECK(std::hypot(p.x, p.y) == Approx(2 - p.z / 5).epsilon(1e-14));
        }
    }
}

TEST_CASE("relabelling a face relabels its transfinite grid") {
    const PointField boundary =
        boundary_of(wavy, {clustered(1e-3), clustered(0.3), identity_law, clustered(0.1)}, 9, 7);
    PointField points = boundary;
    interpolate_face(points, straight_line_map(points));
    for (const Orientation& o : face_orientations()) {
        PointField other = relabelled(boundary, o);
        interpolate_face(other, straight_line_map(other));
        CHECK(greatest_distance(other, relabelled(points, o)) < 4e-15);
    }
}

TEST_CASE("the folded start is folded, keeps the boundary and stays within the face") {
    PointField points = boundary_of(
        [](double s, double t) {
            return Vec3{s, t, 0};
        },
        {identity_law, identity_law, identity_law, identity_law}, 33, 25);
    interpolate_face(points, straight_line_map(points));
    const PointField before = points;
    REQUIRE(folded_cells(before) == 0);
    fold_interior(points);
    check_same_boundary(points, before);
    CHECK(folded_cells(points) > 150);
    for (std::size_t n = 0; n < points.extent().nodes(); ++n) {
        CHECK(points[n].z == 0);
        CHECK((points[n].x >= 0 && points[n].x <= 1 && points[n].y >= 0 && points[n].y <= 1));
    }
}
