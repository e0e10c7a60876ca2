// SPDX-License-Identifier: Apache-2.0
#include "blocks/block_grid.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/largest_first.h"
#include "core/orientation.h"
#include "core/parallel.h"
#include "elliptic/fold_count.h"
#include "faces/hand_built.h"

using namespace hexweave;
using namespace hexweave::test;

namespace {

Vec3 bent(const Vec3& p) {
    return {p.x + 0.15 * std::sin(3 * p.y + p.z), p.y + 0.15 * std::sin(3 * p.z + p.x),
            p.z + 0.15 * std::sin(3 * p.x + p.y)};
}

/// A hexahedron with twelve curved edges, spaced differently.
HandBuilt curved_block(Method method) {
    HandBuilt built;
    built.shape = bent;
    built.method = method;
    std::array<int, 8> corners{};
    for (unsigned c = 0; c < 8; ++c) {
        const unsigned round = c ^ ((c >> 1U) & 1U);  // 0 1 3 2: CGNS goes round the square
        corners[c] =
            built.vertex({round & 1U ? 2.0 : 0.0, round & 2U ? 1.0 : 0.0, round & 4U ? 1.5 : 0.0});
    }
    built.law = clustered(0.2);
    built.between(corners[0], corners[1], 12);
    built.between(corners[4], corners[0], 9);
    built.law = clustered(0.05);
    built.between(corners[1], corners[2], 10);
    built.law = identity_law;
    built.hexahedron(corners, {12, 10, 9});
    return built;
}

void check_sides_are_faces(const Topology& topology, const std::vector<FaceGrid>& faces,
                           const std::vector<BlockGrid>& blocks) {
    for (std::size_t n = 0; n < blocks.size(); ++n) {
        const PointField& points = blocks[n].points;
        for (const Side side : all_sides) {
            const FaceUse& use = topology.blocks[n].side(side).at(0, 0);
            const PointField& face = faces[static_cast<std::size_t>(use.face)].points;
            const IndexBox box = side_box(side, points.extent());
            const auto axes = tangential_axes(side);
            for (int k = box.begin[2]; k <= box.end[2]; ++k) {
                for (int j = box.begin[1]; j <= box.end[1]; ++j) {
                    for (int i = box.begin[0]; i <= box.end[0]; ++i) {
                        const Node own{i, j, k};
                        const Node n2 = map_node(use.orientation,
                                                 {own[static_cast<std::size_t>(axes[0])],
                                                  own[static_cast<std::size_t>(axes[1])], 0},
                                                 face.extent());
                        REQUIRE(points(i, j, k) == face(n2[0], n2[1]));
                    }
                }
            }
        }
    }
}

/// The least of the corner Jacobians over their edges' lengths.
double worst_corner(const PointField& p) {
    double worst = 1;
    const Extent e = p.extent();
    for (int k = 0; k + 1 < e.nk; ++k) {
        for (int j = 0; j + 1 < e.nj; ++j) {
            for (int i = 0; i + 1 < e.ni; ++i) {
                for (int c = 0; c < 8; ++c) {
                    const int x = c & 1, y = (c >> 1) & 1, z = (c >> 2) & 1;
                    const Vec3 a = p(i + 1, j + y, k + z) - p(i, j + y, k + z);
                    const Vec3 b = p(i + x, j + 1, k + z) - p(i + x, j, k + z);
                    const Vec3 d = p(i + x, j + y, k + 1) - p(i + x, j + y, k);
                    worst = std::min(worst, triple(a, b, d) / (norm(a) * norm(b) * norm(d)));
                }
            }
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("an algebraic block has its faces' points on its sides, to the bit") {
    const HandBuilt built = curved_block(Method::algebraic);
    const auto faces = make_faces(built.topology, built.edges);
    int made = 0;
    const auto blocks = make_blocks(built.topology, faces, [&] { ++made; });
    CHECK(made == 1);
    REQUIRE(blocks.size() == 1);
    CHECK(blocks[0].points.extent() == Extent{13, 11, 10});
    CHECK(blocks[0].solve.status == SolveStatus::algebraic);
    check_sides_are_faces(built.topology, faces, blocks);
}

TEST_CASE("six elliptic faces and an elliptic block converge, are sound and keep their boundary") {
    HandBuilt built = curved_block(Method::elliptic);
    const auto faces = make_faces(built.topology, built.edges);
    for (const FaceGrid& face : faces) {
        CHECK(face.solve.status == SolveStatus::converged);
        CHECK(face.solve.cycles > 0);
    }
    const auto blocks = make_blocks(built.topology, faces);
    CHECK(blocks[0].solve.status == SolveStatus::converged);
    check_sides_are_faces(built.topology, faces, blocks);
    CHECK(worst_corner(blocks[0].points) > 0.3);
}

TEST_CASE("the elliptic block does not depend on its start grid") {
    HandBuilt built = curved_block(Method::elliptic);
    const auto solved = [&](bool folded) {
        for (Face& face : built.topology.faces) {
            face.solve.start_folded = folded;
            face.solve.tolerance = 1e-8;
        }
        built.topology.blocks[0].solve.start_folded = folded;
        built.topology.blocks[0].solve.tolerance = 1e-8;
        const auto faces = make_faces(built.topology, built.edges);
        return make_blocks(built.topology, faces)[0];
    };
    const BlockGrid plain = solved(false);
    const BlockGrid folded = solved(true);
    CHECK(plain.solve.status == SolveStatus::converged);
    CHECK(folded.solve.status == SolveStatus::converged);
    CHECK(folded.solve.folded_before > 300);
    CHECK(folded.solve.folded_after == 0);
    // Cells are about 0.1 wide, the smallest 0.005.
    CHECK(greatest_distance(plain.points, folded.points) < 1e-6 * 0.005);
}

TEST_CASE("an affine image of a product grid is a fixed point of the elliptic system") {
    HandBuilt built;
    built.method = Method::elliptic;
    built.law = clustered(0.02);
    built.shape = [](const Vec3& p) {
        return Vec3{p.x + 0.3 * p.y, p.y - 0.2 * p.z, p.z + 0.1 * p.x};
    };
    std::array<int, 8> corners{};
    for (unsigned c = 0; c < 8; ++c) {
        const unsigned round = c ^ ((c >> 1U) & 1U);
        corners[c] =
            built.vertex({round & 1U ? 1.0 : 0.0, round & 2U ? 1.0 : 0.0, round & 4U ? 1.0 : 0.0});
    }
    built.hexahedron(corners, {8, 8, 8});
    const auto faces = make_faces(built.topology, built.edges);
    const auto blocks = make_blocks(built.topology, faces);
    const PointField& points = blocks[0].points;
    for (int k = 0; k <= 8; ++k) {
        for (int j = 0; j <= 8; ++j) {
            for (int i = 0; i <= 8; ++i) {
                const Vec3 exact =
                    built.shape({built.law(i / 8.0), built.law(j / 8.0), built.law(k / 8.0)});
                // The first residuals are in single precision: 1e-7 is a hundred-thousandth of a
                // cell.
                CHECK(distance(points(i, j, k), exact) < 1e-7);
            }
        }
    }
}

TEST_CASE("a large block among small ones has the same bits on any number of threads") {
    // Large enough to be made alone, with all threads inside, and the rest at once.
    HandBuilt built;
    built.shape = bent;
    built.method = Method::elliptic;
    std::vector<std::array<int, 4>> planes;
    for (const double x : {0.0, 1.0, 1.2, 1.5, 1.7}) {
        planes.push_back({built.vertex({x, 0, 0}), built.vertex({x, 1, 0}), built.vertex({x, 1, 1}),
                          built.vertex({x, 0, 1})});
    }
    built.law = clustered(0.1);
    const std::array<int, 4> cells_i{40, 5, 6, 5};
    for (std::size_t n = 0; n < 4; ++n) {
        const auto& [a, b, c, d] = planes[n];
        const auto& [e, f, g, h] = planes[n + 1];
        built.hexahedron({a, e, f, b, d, h, g, c}, {cells_i[n], 22, 22});
    }
    REQUIRE(built.topology.blocks[0].extent.nodes() > worth_all_threads);
    const int before = threads();
    std::vector<FaceGrid> faces_of_one;
    std::vector<BlockGrid> of_one;
    for (const int count : {1, 2, 4, 7}) {
        set_threads(count);
        auto faces = make_faces(built.topology, built.edges);
        auto blocks = make_blocks(built.topology, faces);
        if (count == 1) {
            faces_of_one = faces;
            of_one = blocks;
        }
        for (std::size_t n = 0; n < faces.size(); ++n) {
            CHECK(greatest_distance(faces[n].points, faces_of_one[n].points) == 0);
        }
        for (std::size_t n = 0; n < blocks.size(); ++n) {
            CHECK(blocks[n].solve.status == SolveStatus::converged);
            CHECK(blocks[n].solve.folded_after == 0);
            CHECK(blocks[n].solve.history == of_one[n].solve.history);
            CHECK(greatest_distance(blocks[n].points, of_one[n].points) == 0);
        }
    }
    set_threads(before);
}

TEST_CASE("folded cells of an algebraic block are counted") {
    HandBuilt built = curved_block(Method::algebraic);
    auto faces = make_faces(built.topology, built.edges);
    CHECK(make_blocks(built.topology, faces)[0].solve.folded_after == 0);
    // A side drawn deep into the block.
    PointField& side =
        faces[static_cast<std::size_t>(built.topology.blocks[0].sides[4].faces[0].face)].points;
    side.set(5, 5, 0, side(5, 5) + Vec3{0, 0, 3});
    const BlockGrid folded = make_blocks(built.topology, faces)[0];
    CHECK(folded.solve.status == SolveStatus::algebraic);
    CHECK(folded.solve.folded_after > 0);
    CHECK(folded.solve.folded_after == count_folded(folded.points));
    CHECK(folded.solve.folded_before == folded.solve.folded_after);
}

TEST_CASE("grids are the same to the bit with one thread and with three") {
    HandBuilt built = curved_block(Method::elliptic);
    const int before = threads();
    set_threads(1);
    const auto faces_one = make_faces(built.topology, built.edges);
    const auto one = make_blocks(built.topology, faces_one);
    set_threads(3);
    const auto faces_three = make_faces(built.topology, built.edges);
    const auto three = make_blocks(built.topology, faces_three);
    set_threads(before);
    CHECK(greatest_distance(one[0].points, three[0].points) == 0);
}
