// SPDX-License-Identifier: Apache-2.0
#include "blocks/block_boundary.h"

#include "core/assert.h"

namespace hexweave {

namespace {

/// Calls visit(node of the block, point of the face) for every node of one side.
template <class Visit>
void visit_side(const Block& block, Side side, const std::vector<FaceGrid>& faces, Visit&& visit) {
    const FaceUse& use = block.side(side);
    const PointField& face = faces[static_cast<std::size_t>(use.face)].points;
    const auto [a_axis, b_axis] = tangential_axes(side);
    const Extent own{block.extent[a_axis], block.extent[b_axis], 1};
    HEXWEAVE_ASSERT(own == own_extent(use.orientation, face.extent()));
    for (int b = 0; b < own.nj; ++b) {
        for (int a = 0; a < own.ni; ++a) {
            const Node n = map_node(use.orientation, {a, b, 0}, face.extent());
            visit(side_node(side, a, b, block.extent), face(n[0], n[1], n[2]));
        }
    }
}

/// Two faces of a block that share an edge hold the same points there.
[[maybe_unused]] bool sides_agree(const PointField& points, const Block& block,
                                  const std::vector<FaceGrid>& faces) {
    bool agree = true;
    for (const Side side : all_sides) {
        visit_side(block, side, faces, [&](const Node& n, const Vec3& p) {
            agree = agree && points(n[0], n[1], n[2]) == p;
        });
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

PointField block_boundary(const Block& block, const std::vector<FaceGrid>& faces) {
    PointField points(block.extent);
    for (const Side side : all_sides) {
        visit_side(block, side, faces,
                   [&](const Node& n, const Vec3& p) { points.set(n[0], n[1], n[2], p); });
    }
    HEXWEAVE_ASSERT(sides_agree(points, block, faces));
    return points;
}

}  // namespace hexweave
