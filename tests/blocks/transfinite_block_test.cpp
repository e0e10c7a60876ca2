// SPDX-License-Identifier: Apache-2.0
#include "blocks/transfinite_block.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "blocks/bilinear_map.h"
#include "blocks/block_boundary.h"
#include "core/orientation.h"
#include "faces/hand_built.h"
#include "faces/straight_line_map.h"
#include "faces/transfinite_face.h"

using namespace hexweave;
using namespace hexweave::test;

namespace {

using Law = std::function<double(double)>;
using Map = std::function<Vec3(double, double, double)>;

bool on_boundary(const Extent& e, int i, int j, int k) {
    return i == 0 || j == 0 || k == 0 || i == e.ni - 1 || j == e.nj - 1 || k == e.nk - 1;
}

template <class Visit>
void for_each_node(const Extent& e, Visit&& visit) {
    for (int k = 0; k < e.nk; ++k) {
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) visit(i, j, k);
        }
    }
}

/// Sets the twelve edges to the image of the unit cube's, with law 4 * axis + edge on each, and the
/// six sides by transfinite interpolation of their own edges.
PointField block_of_edges(const Map& map, const std::array<Law, 12>& laws, const Extent& e) {
    PointField points(e);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t first = axis == 0 ? 1 : 0;
        const std::size_t second = axis == 2 ? 1 : 2;
        for (std::size_t edge = 0; edge < 4; ++edge) {
            const int cells = e[static_cast<int>(axis)] - 1;
            for (int n = 0; n <= cells; ++n) {
                std::array<double, 3> x{};
                Node node{};
                x[axis] = laws[4 * axis + edge](static_cast<double>(n) / cells);
                node[axis] = n;
                for (const auto& [a, bit] : {std::pair{first, edge % 2}, {second, edge / 2}}) {
                    x[a] = static_cast<double>(bit);
                    node[a] = bit ? e[static_cast<int>(a)] - 1 : 0;
                }
                points.set(node[0], node[1], node[2], map(x[0], x[1], x[2]));
            }
        }
    }
    for (const Side side : all_sides) {
        const auto axes = tangential_axes(side);
        PointField face(Extent{e[axes[0]], e[axes[1]], 1});
        for_each_node(face.extent(), [&](int a, int b, int) {
            const Node n = side_node(side, a, b, e);
            face.set(a, b, 0, points(n[0], n[1], n[2]));
        });
        interpolate_face(face, straight_line_map(face));
        for_each_node(face.extent(), [&](int a, int b, int) {
            const Node n = side_node(side, a, b, e);
            points.set(n[0], n[1], n[2], face(a, b));
        });
    }
    return points;
}

std::array<Law, 12> different_laws() {
    std::array<Law, 12> laws;
    for (std::size_t n = 0; n < 12; ++n) {
        laws[n] = clustered(std::pow(0.3, static_cast<double>((n * 5) % 12)));
    }
    return laws;
}

Vec3 trilinear(double s, double t, double u) {
    const Vec3 low = lerp(lerp(Vec3{0, 0, 0}, Vec3{2, 0.3, 0}, s),
                          lerp(Vec3{-0.4, 1, 0.2}, Vec3{3, 2, 0.5}, s), t);
    const Vec3 high =
        lerp(lerp(Vec3{0.5, 0.1, 1}, Vec3{2, 0, 1.5}, s), lerp(Vec3{0, 1, 2}, Vec3{2, 2, 1}, s), t);
    return lerp(low, high, u);
}

Vec3 wavy(double s, double t, double u) {
    return {s + 0.1 * std::sin(4 * t + u), t + 0.1 * std::sin(3 * u) * s,
            u + 0.2 * std::sin(3 * s) * t};
}

PointField relabelled(const PointField& points, const Orientation& o) {
    PointField result(own_extent(o, points.extent()));
    for_each_node(result.extent(), [&](int i, int j, int k) {
        const Node n = map_node(o, {i, j, k}, points.extent());
        result.set(i, j, k, points(n[0], n[1], n[2]));
    });
    return result;
}

}  // namespace

TEST_CASE("transfinite interpolation of a block keeps its boundary to the bit") {
    const Extent e{6, 5, 7};
    const PointField boundary = block_of_edges(wavy, different_laws(), e);
    PointField points = boundary;
    interpolate_block(points, bilinear_map(points));
    for_each_node(e, [&](int i, int j, int k) {
        if (on_boundary(e, i, j, k)) CHECK(points(i, j, k) == boundary(i, j, k));
    });
}

TEST_CASE("transfinite interpolation of a block is exact for trilinear maps with any twelve laws") {
    const Extent e{8, 6, 7};
    PointField points = block_of_edges(trilinear, different_laws(), e);
    const ParameterField p = bilinear_map(points);
    interpolate_block(points, p);
    for (std::size_t n = 0; n < e.nodes(); ++n) {
        CHECK(distance(points[n], trilinear(p.s[n], p.t[n], p.u[n])) < 1e-14);
    }
}

TEST_CASE("with equal laws a block's interpolation is the Boolean sum of Gordon and Hall") {
    // Sums of terms that are linear in one coordinate are reproduced, whatever they are in the
    // others.
    const auto map = [](double s, double t, double u) {
        return Vec3{s + std::sin(3 * t) * std::cos(2 * u) * (1 + s), t + std::exp(s * u) * (2 - t),
                    u * std::sin(2 * s + t) - std::cos(s + 3 * t)};
    };
    const Extent e{6, 7, 8};
    PointField points(e);
    ParameterField p{Field(e), Field(e), Field(e)};
    for_each_node(e, [&](int i, int j, int k) {
        const std::size_t n = e.offset(i, j, k);
        p.s[n] = i / 5.0;
        p.t[n] = std::pow(j / 6.0, 2);
        p.u[n] = k / 7.0;
        if (on_boundary(e, i, j, k)) points.set(n, map(p.s[n], p.t[n], p.u[n]));
    });
    interpolate_block(points, p);
    for (std::size_t n = 0; n < e.nodes(); ++n) {
        CHECK(distance(points[n], map(p.s[n], p.t[n], p.u[n])) < 4e-15);
    }
}

TEST_CASE("a block between two coaxial cones is exact") {
    // i round a quarter, j outwards (clustered), k along the axis.
    const auto cones = [](double s, double t, double u) {
        const double angle = 0.5 * std::numbers::pi * s;
        const double radius = (1 + t) * (1 - 0.4 * u);
        return Vec3{radius * std::cos(angle), radius * std::sin(angle), 3 * u};
    };
    std::array<Law, 12> laws;
    for (std::size_t n = 0; n < 12; ++n) laws[n] = n / 4 == 1 ? clustered(1e-4) : identity_law;
    const Extent e{17, 12, 9};
    PointField points = block_of_edges(cones, laws, e);
    interpolate_block(points, bilinear_map(points));
    for_each_node(e, [&](int i, int j, int k) {
        const Vec3 exact = cones(i / 16.0, laws[4](j / 11.0), k / 8.0);
        CHECK(distance(points(i, j, k), exact) < 1e-14);
    });
}

TEST_CASE("relabelling a block relabels its transfinite grid") {
    const Extent e{6, 5, 7};
    const PointField boundary = block_of_edges(wavy, different_laws(), e);
    PointField points = boundary;
    interpolate_block(points, bilinear_map(points));
    for (const auto& axes : {std::array{2, 3, 1}, {-1, 3, 2}, {3, -2, -1}, {-2, -1, -3}}) {
        PointField other = relabelled(boundary, {axes});
        interpolate_block(other, bilinear_map(other));
        CHECK(greatest_distance(other, relabelled(points, {axes})) < 1e-14);
    }
}
