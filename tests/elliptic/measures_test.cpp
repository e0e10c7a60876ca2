// SPDX-License-Identifier: Apache-2.0
// Displacements in cells, and counts of folded cells.
#include <catch2/catch.hpp>
#include <cmath>

#include "elliptic/cell_units.h"
#include "elliptic/fold_count.h"
#include "elliptic/shapes.h"

namespace hexweave {
namespace {

const double pi = std::acos(-1.0);

Vec3 uniform(double xi, double eta, double zeta) {
    return {xi, eta, zeta};
}

/// Flat, long, leaning cells: the cells of a boundary layer.
Vec3 sheared(double xi, double eta, double zeta) {
    return {4 * xi + 2 * eta + zeta, 4e-5 * eta, 4 * zeta - eta};
}

}  // namespace

TEST_CASE("a move along a grid line by its spacing is one cell, whatever the cell's shape") {
    const Extent e{5, 5, 5};
    const NodeLattice lattice(e);
    const Nodes x = shapes::nodes_of(shapes::sample(e, sheared));
    const std::size_t centre = e.offset(2, 2, 2);
    const CellFrame frame = cell_frame(lattice, x, centre, 0);
    const auto along = [&](std::ptrdiff_t d) {
        return frame.cells(*(x.data() + centre + d) - x[centre]);
    };
    CHECK(distance(along(lattice.strides[0]), {1, 0, 0}) < 1e-9);
    CHECK(distance(along(lattice.strides[1]), {0, 1, 0}) < 1e-9);
    CHECK(distance(along(lattice.strides[2]), {0, 0, 1}) < 1e-9);
}

TEST_CASE("on a face in space the third measure is along the normal") {
    const Extent e{3, 3, 1};
    const NodeLattice lattice(e);
    const Nodes x = shapes::nodes_of(shapes::sample(e, [](double xi, double eta, double) {
        return Vec3{8 * xi, eta, eta};
    }));
    const CellFrame frame = cell_frame(lattice, x, 4, 0);
    CHECK(distance(frame.cells({4, 0, 0}), {1, 0, 0}) < 1e-14);
    CHECK(distance(frame.cells({0, 0.5, 0.5}), {0, 1, 0}) < 1e-14);
    const double area = 4 * std::sqrt(0.5);
    CHECK(std::abs(frame.cells({0, -1, 1}).z) == Approx(std::sqrt(2 / area)));
}

TEST_CASE("the largest displacement is that of the worst node along the worst axis") {
    const Extent e{5, 5, 1};
    const NodeLattice lattice(e);
    const Nodes x = shapes::nodes_of(shapes::sample(e, [](double xi, double eta, double) {
        return Vec3{xi, 0.01 * eta, 0};
    }));
    Nodes displacement(x.size());
    displacement[e.offset(1, 1)] = {0.1, 0, 0};
    CHECK(largest_displacement(lattice, x, displacement) == Approx(0.4));
    displacement[e.offset(3, 2)] = {0, -0.01, 0};
    CHECK(largest_displacement(lattice, x, displacement) == Approx(4));
    displacement[e.offset(2, 2)] = {std::nan(""), 0, 0};
    CHECK_FALSE(std::isfinite(largest_displacement(lattice, x, displacement)));
}

TEST_CASE("displacements in flat and collapsed cells are finite") {
    const Extent e{3, 3, 3};
    const NodeLattice lattice(e);
    const Nodes flat = shapes::nodes_of(shapes::sample(e, [](double xi, double eta, double) {
        return Vec3{xi, eta, xi + eta};
    }));
    const Nodes displacement(flat.size(), Vec3{1, 1, 1});
    CHECK(std::isfinite(largest_displacement(lattice, flat, displacement)));
    CHECK(largest_displacement(lattice, Nodes(flat.size()), displacement) == 0);
}

TEST_CASE("sound grids have no folded cell") {
    CHECK(count_folded(shapes::sample({5, 4, 1}, uniform)) == 0);
    CHECK(count_folded(shapes::sample({5, 4, 3}, uniform)) == 0);
    const auto clockwise = [](double xi, double eta, double) { return Vec3{eta, xi, 0}; };
    CHECK(count_folded(shapes::sample({5, 4, 1}, clockwise)) == 0);
    const auto tube = [](double xi, double eta, double) {
        return Vec3{std::cos(6 * xi), std::sin(6 * xi), eta};
    };
    CHECK(count_folded(shapes::sample({33, 9, 1}, tube)) == 0);
}

TEST_CASE("a node pushed across its neighbour folds the cells between them") {
    PointField face = shapes::sample({5, 5, 1}, uniform);
    face.set(2, 2, 0, {0.8, 0.5, 0});
    CHECK(count_folded(face) == 2);
    face.set(0, 0, 0, {0, 0, 1e-3});
    CHECK(count_folded(face) == 2);
    PointField block = shapes::sample({5, 5, 5}, uniform);
    block.set(2, 2, 2, {0.8, 0.5, 0.5});
    CHECK(count_folded(block) == 4);
}

TEST_CASE("collapsed and left-handed cells of a block are folded") {
    const auto mirrored = [](double xi, double eta, double zeta) { return Vec3{eta, xi, zeta}; };
    CHECK(count_folded(shapes::sample({3, 4, 5}, mirrored)) == 24);
    const auto flat = [](double xi, double eta, double) { return Vec3{xi, eta, xi}; };
    CHECK(count_folded(shapes::sample({3, 4, 5}, flat)) == 24);
}

}  // namespace hexweave
