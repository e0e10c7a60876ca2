// SPDX-License-Identifier: Apache-2.0
#include "blocks/block_boundary.h"

#include "core/assert.h"

namespace hexweave {

namespace {

/// Calls visit(node of the side, point) for every node of one face on a block's side.
template <class Visit>
void visit_face(const FaceUse& use, const std::vector<FaceGrid>& faces, Visit&& visit) {
    const PointField& face = faces[static_cast<std::size_t>(use.face)].points;
    const Extent own = own_extent(use.orientation, face.extent());
    for (int b = 0; b < own.nj; ++b) {
        for (int a = 0; a < own.ni; ++a) {
            const Node n = map_node(use.orientation, {a, b, 0}, face.extent());
            visit(Node{use.begin[0] + a, use.begin[1] + b, 0}, face(n[0], n[1], n[2]));
        }
    }
}

/// Two faces of a block that share an edge hold the same points there.
[[maybe_unused]] bool sides_agree(const PointField& points, const Block& block,
                                  const std::vector<FaceGrid>& faces) {
    bool agree = true;
    for (const Side side : all_sides) {
        for (const FaceUse& use : block.side(side).faces) {
            visit_face(use, faces, [&](const Node& on_side, const Vec3& p) {
                const Node n = side_node(side, on_side[0], on_side[1], block.extent);
                agree = agree && points(n[0], n[1], n[2]) == p;
            });
        }
    }
    return agree;
}

}  // namespace

Node side_node(Side side, int a, int b, const Extent& block) {
    const auto [a_axis, b_axis] = tangential_axes(side);
    Node n{};
    n[static_cast<std::size_t>(axis_of(side))] = is_max(side) ? block[axis_of(side)] - 1 : 0;
    n[static_cast<std::size_t>(a_axis)] = a;
    n[static_cast<std::size_t>(b_axis)] = b;
    return n;
}

PointField side_points(const Block& block, Side side, const std::vector<FaceGrid>& faces) {
    const auto [a_axis, b_axis] = tangential_axes(side);
    PointField points(Extent{block.extent[a_axis], block.extent[b_axis], 1});
    [[maybe_unused]] std::size_t cells = 0;
    for (const FaceUse& use : block.side(side).faces) {
        visit_face(use, faces, [&](const Node& n, const Vec3& p) { points.set(n[0], n[1], 0, p); });
        cells += faces[static_cast<std::size_t>(use.face)].points.extent().cells();
    }
    HEXWEAVE_ASSERT(cells == points.extent().cells());
    return points;
}

PointField block_boundary(const Block& block, const std::vector<FaceGrid>& faces) {
    PointField points(block.extent);
    for (const Side side : all_sides) {
        const PointField on_side = side_points(block, side, faces);
        const Extent e = on_side.extent();
        for (int b = 0; b < e.nj; ++b) {
            for (int a = 0; a < e.ni; ++a) {
                const Node n = side_node(side, a, b, block.extent);
                points.set(n[0], n[1], n[2], on_side(a, b));
            }
        }
    }
    HEXWEAVE_ASSERT(sides_agree(points, block, faces));
    return points;
}

}  // namespace hexweave
