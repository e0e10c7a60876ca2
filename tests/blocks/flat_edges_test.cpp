// SPDX-License-Identifier: Apache-2.0
#include "blocks/flat_edges.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "blocks/block_grid.h"
#include "faces/hand_built.h"

using namespace hexweave;
using namespace hexweave::test;

namespace {

/// Eight vertices over the quadrilateral at z = 0 and z = 1, in the order of the CGNS hexahedron.
struct Prism {
    std::array<int, 4> low{};
    std::array<int, 4> high{};

    std::array<int, 8> corners() const {
        return {low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3]};
    }
};

struct Planes {
    HandBuilt built;
    Prism wing;
    Prism wake;
};

/// The half plane over y = 0 as a prism whose sides jmin (x > 0) and imin (x < 0) meet at 180
/// degrees in the line x = y = 0, where its first corner is; and below its jmin a box.
Planes half_plane_and_box() {
    Planes planes;
    HandBuilt& built = planes.built;
    built.method = Method::elliptic;
    const auto both = [&](double x, double y) {
        return std::array{built.vertex({x, y, 0}), built.vertex({x, y, 1})};
    };
    const auto origin = both(0, 0), right = both(1, 0), up = both(0, 1), left = both(-1, 0);
    const auto low_left = both(0, -1), low_right = both(1, -1);
    planes.wing = {{origin[0], right[0], up[0], left[0]}, {origin[1], right[1], up[1], left[1]}};
    planes.wake = {{low_left[0], low_right[0], right[0], origin[0]},
                   {low_left[1], low_right[1], right[1], origin[1]}};
    built.hexahedron(planes.wing.corners(), {6, 6, 4});
    built.hexahedron(planes.wake.corners(), {6, 5, 4});
    return planes;
}

int count(const PerBlockEdge<bool>& flat) {
    int sum = 0;
    for (const auto& axis : flat)
        sum += static_cast<int>(std::count(axis.begin(), axis.end(), true));
    return sum;
}

}  // namespace

TEST_CASE("sides that meet at 180 degrees are found, whichever way the block is turned") {
    // The corners of the half plane's prism, begun at each of its four columns.
    for (std::size_t turn = 0; turn < 4; ++turn) {
        const Planes planes = half_plane_and_box();
        HandBuilt built;
        built.method = Method::algebraic;
        built.topology.vertices = planes.built.topology.vertices;
        built.reference = planes.built.reference;
        Prism turned = planes.wing;
        std::rotate(turned.low.begin(), turned.low.begin() + static_cast<int>(turn),
                    turned.low.end());
        std::rotate(turned.high.begin(), turned.high.begin() + static_cast<int>(turn),
                    turned.high.end());
        built.hexahedron(turned.corners(), {6, 6, 4});
        const auto faces = make_faces(built.topology, built.edges);
        const PerBlockEdge<bool> flat = flat_edges(built.topology.blocks[0], faces);
        CHECK(count(flat) == 1);
        // The origin is corner 0, 3, 2, 1 of the round: (min, min), (min, max), (max, max), ...
        constexpr std::array<std::size_t, 4> number{0, 2, 3, 1};
        CHECK(flat[2][number[turn]]);
    }
}

TEST_CASE(
    "angles of blocks up to 150 degrees are not flat, nor is a slit; from there on they are") {
    const auto flat_at = [](double degrees) {
        HandBuilt built;
        const double angle = degrees / 180 * std::acos(-1.0);
        std::array<int, 8> corners{};
        const std::array<Vec3, 4> round{Vec3{0, 0, 0}, Vec3{1, 0, 0},
                                        3 * Vec3{std::cos(angle / 2), std::sin(angle / 2), 0},
                                        Vec3{std::cos(angle), std::sin(angle), 0}};
        for (std::size_t c = 0; c < 8; ++c) {
            corners[c] = built.vertex(round[c % 4] + Vec3{0, 0, c < 4 ? 0.0 : 1.0});
        }
        built.hexahedron(corners, {4, 4, 3});
        const auto faces = make_faces(built.topology, built.edges);
        return flat_edges(built.topology.blocks[0], faces)[2][0];
    };
    CHECK_FALSE(flat_at(90));
    CHECK_FALSE(flat_at(149));
    CHECK(flat_at(151));
    CHECK(flat_at(180));
    CHECK(flat_at(200));
    CHECK(flat_at(280));
    CHECK_FALSE(flat_at(331));
}

TEST_CASE("a cube has no flat edge") {
    HandBuilt built;
    std::array<int, 8> corners{};
    for (unsigned c = 0; c < 8; ++c) {
        const unsigned round = c ^ ((c >> 1U) & 1U);
        corners[c] =
            built.vertex({round & 1U ? 1.0 : 0.0, round & 2U ? 1.0 : 0.0, round & 4U ? 1.0 : 0.0});
    }
    built.hexahedron(corners, {3, 4, 5});
    const auto faces = make_faces(built.topology, built.edges);
    CHECK(count(flat_edges(built.topology.blocks[0], faces)) == 0);
    const auto functions = block_edge_functions(built.topology, faces);
    for (const auto& axis : functions[0].exponents) {
        for (const EndExponents& ends : axis) CHECK(ends == EndExponents{1, 1});
    }
}

TEST_CASE("an edge that ends in a flat edge has its exponent in both blocks that share it") {
    Planes planes = half_plane_and_box();
    Topology& topology = planes.built.topology;
    topology.blocks[0].solve.flat_edge_exponent = 0.6;
    const auto faces = make_faces(topology, planes.built.edges);
    const auto functions = block_edge_functions(topology, faces);
    REQUIRE(functions[0].flat.size() == 1);
    const auto rows = block_edges(topology, topology.blocks[0]);
    const EdgeUse upright = rows[2][0].front();
    CHECK(functions[0].flat[0] == topology.edges[static_cast<std::size_t>(upright.edge)].name);
    CHECK(functions[1].flat.empty());

    // i and j leave the origin, the first corner of the half plane, at both ends of the flat edge.
    const EndExponents at_start{0.6, 1};
    const EndExponents none{1, 1};
    const auto& wing = functions[0].exponents;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        CHECK(wing[axis][0] == at_start);
        CHECK(wing[axis][1] == none);
        CHECK(wing[axis][2] == at_start);
        CHECK(wing[axis][3] == none);
    }
    for (const EndExponents& ends : wing[2]) CHECK(ends == none);
    // The box has the half plane's jmin as its jmax; its other edge at the origin is not flat.
    const auto& wake = functions[1].exponents;
    CHECK(wake[0][0] == none);
    CHECK(wake[0][1] == at_start);
    CHECK(wake[0][2] == none);
    CHECK(wake[0][3] == at_start);
    for (const EndExponents& ends : wake[1]) CHECK(ends == none);
}

TEST_CASE("an extruded block with a flat edge has the same grid in every plane") {
    Planes planes = half_plane_and_box();
    Topology& topology = planes.built.topology;
    for (Face& face : topology.faces) {
        face.solve.flat_edge_exponent = 0.7;
        face.solve.tolerance = 1e-8;
    }
    topology.blocks[0].solve.flat_edge_exponent = 0.7;
    topology.blocks[0].solve.tolerance = 1e-8;
    const auto faces = make_faces(topology, planes.built.edges);
    const PointField points = make_blocks(topology, faces)[0].points;
    const Extent e = points.extent();
    for (int k = 1; k < e.nk; ++k) {
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) {
                const Vec3 up{0, 0, k / 4.0};
                CHECK(distance(points(i, j, k), points(i, j, 0) + up) < 1e-7);
            }
        }
    }
}

TEST_CASE("grid lines cross the sides at a flat edge less aslant with the exponent") {
    Planes planes = half_plane_and_box();
    // How far the first line off x > 0 has gone along x, by how far it is off, near the origin.
    const auto aslant = [&](double exponent) {
        for (Face& face : planes.built.topology.faces) face.solve.flat_edge_exponent = 1;
        for (Block& block : planes.built.topology.blocks) {
            block.solve.flat_edge_exponent = exponent;
        }
        const auto faces = make_faces(planes.built.topology, planes.built.edges);
        const auto blocks = make_blocks(planes.built.topology, faces);
        REQUIRE(blocks[0].solve.status == SolveStatus::converged);
        const Vec3 leg = blocks[0].points(1, 1, 2) - blocks[0].points(1, 0, 2);
        return std::abs(leg.x / leg.y);
    };
    CHECK(aslant(0.7) < 0.8 * aslant(1));
    CHECK(aslant(0.5) < aslant(0.7));
}
