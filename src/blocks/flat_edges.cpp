// SPDX-License-Identifier: Apache-2.0
#include "blocks/flat_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blocks/block_boundary.h"
#include "faces/flat_corners.h"
#include "topology/face_frame.h"

namespace hexweave {

namespace {

/// The two axes across a block's edges along one axis, ascending.
constexpr std::array<std::array<int, 2>, 3> across{{{1, 2}, {0, 2}, {0, 1}}};

Side side_at(int axis, bool max) {
    return static_cast<Side>(2 * axis + (max ? 1 : 0));
}

/// The points of a block's six sides.
using SidePoints = std::array<PointField, 6>;

/// A node of the block's boundary, on the given side.
Vec3 boundary_point(const SidePoints& points, Side side, const Node& node) {
    const auto [a, b] = tangential_axes(side);
    return points[static_cast<std::size_t>(side)](node[static_cast<std::size_t>(a)],
                                                  node[static_cast<std::size_t>(b)]);
}

/// The angle through the block between two legs from a node of an edge, seen along it; `sign` makes
/// the triple product positive in a right-handed block.
double angle_about(const Vec3& along, const Vec3& first, const Vec3& second, int sign) {
    const double length = norm(along);
    const Vec3 axis = length > 0 ? along / length : Vec3{};
    const double sine = sign * triple(first, second, axis);
    const double cosine = dot(first, second) - dot(first, axis) * dot(second, axis);
    const double angle = std::atan2(sine, cosine);
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

bool is_flat(const Extent& extent, int axis, std::size_t number, const SidePoints& points) {
    const int first = across[static_cast<std::size_t>(axis)][0];
    const int second = across[static_cast<std::size_t>(axis)][1];
    const bool first_max = number % 2 == 1;
    const bool second_max = number / 2 == 1;
    // The leg along the first axis lies on the side that is constant in the second.
    const Side first_side = side_at(second, second_max);
    const Side second_side = side_at(first, first_max);
    const int inward_first = first_max ? -1 : 1;
    const int inward_second = second_max ? -1 : 1;
    const int sign = (axis == 1 ? -1 : 1) * inward_first * inward_second;
    const int nodes = extent[axis];
    const auto node_at = [&](int n, int steps_first, int steps_second) {
        Node node{};
        node[static_cast<std::size_t>(axis)] = n;
        node[static_cast<std::size_t>(first)] = (first_max ? extent[first] - 1 : 0) + steps_first;
        node[static_cast<std::size_t>(second)] =
            (second_max ? extent[second] - 1 : 0) + steps_second;
        return node;
    };
    int flat = 0;
    for (int n = 0; n < nodes; ++n) {
        const auto edge_point = [&](int m) {
            return boundary_point(points, first_side, node_at(m, 0, 0));
        };
        const Vec3 here = edge_point(n);
        const Vec3 along = edge_point(std::min(n + 1, nodes - 1)) - edge_point(std::max(n - 1, 0));
        if (along == Vec3{}) continue;  // a pole
        const Vec3 leg_first =
            boundary_point(points, first_side, node_at(n, inward_first, 0)) - here;
        const Vec3 leg_second =
            boundary_point(points, second_side, node_at(n, 0, inward_second)) - here;
        const double angle = angle_about(along, leg_first, leg_second, sign);
        if (angle > flat_angle && angle < slit_angle) ++flat;
    }
    return 2 * flat > nodes;
}

/// The exponents at both ends of every edge of the topology.
using TopologyExponents = std::vector<EndExponents>;

/// The exponent at the first (or last) end of a row of edges.
double& exponent_at(TopologyExponents& exponents, const std::vector<EdgeUse>& row, bool last) {
    const EdgeUse& use = last ? row.back() : row.front();
    EndExponents& ends = exponents[static_cast<std::size_t>(use.edge)];
    return use.reversed == last ? ends.start : ends.end;
}

/// Enters the exponent of one flat edge at the four ends that lie in it.
void enter_flat_edge(const PerBlockEdge<std::vector<EdgeUse>>& rows, int axis, std::size_t number,
                     double exponent, TopologyExponents& exponents) {
    const auto [first, second] = across[static_cast<std::size_t>(axis)];
    const std::array<bool, 2> max{number % 2 == 1, number / 2 == 1};
    for (std::size_t leg = 0; leg < 2; ++leg) {
        const int ending = leg == 0 ? first : second;  // the axis of the edges that end here
        const int other = leg == 0 ? second : first;
        const auto& axes = across[static_cast<std::size_t>(ending)];
        for (std::size_t station = 0; station < 2; ++station) {
            std::size_t ending_number = 0;
            for (std::size_t n = 0; n < 2; ++n) {
                const bool at_max = axes[n] == other ? max[1 - leg] : station == 1;
                if (at_max) ending_number += n + 1;
            }
            double& entry = exponent_at(
                exponents, rows[static_cast<std::size_t>(ending)][ending_number], max[leg]);
            entry = std::min(entry, exponent);
        }
    }
}

}  // namespace

PerBlockEdge<std::vector<EdgeUse>> block_edges(const Topology& topology, const Block& block) {
    const auto frame = [&](Side side) { return sides_in_frame(topology.faces, block.side(side)); };
    PerBlockEdge<std::vector<EdgeUse>> rows;
    for (std::size_t max = 0; max < 2; ++max) {
        const FrameSides at_j = frame(side_at(1, max == 1));
        const FrameSides at_i = frame(side_at(0, max == 1));
        for (std::size_t other = 0; other < 2; ++other) {
            rows[0][max + 2 * other] = at_j[2 + other];
            rows[1][max + 2 * other] = at_i[2 + other];
            rows[2][max + 2 * other] = at_i[other];
        }
    }
    return rows;
}

PerBlockEdge<bool> flat_edges(const Block& block, const std::vector<FaceGrid>& faces) {
    SidePoints points;
    for (const Side side : all_sides) {
        points[static_cast<std::size_t>(side)] = side_points(block, side, faces);
    }
    PerBlockEdge<bool> flat{};
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t number = 0; number < 4; ++number) {
            flat[static_cast<std::size_t>(axis)][number] =
                is_flat(block.extent, axis, number, points);
        }
    }
    return flat;
}

std::vector<BlockEdgeFunctions> block_edge_functions(const Topology& topology,
                                                     const std::vector<FaceGrid>& faces) {
    std::vector<BlockEdgeFunctions> result(topology.blocks.size());
    TopologyExponents exponents(topology.edges.size());
    std::vector<PerBlockEdge<std::vector<EdgeUse>>> rows;
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
        const Block& block = topology.blocks[b];
        rows.push_back(block_edges(topology, block));
        const PerBlockEdge<bool> flat = flat_edges(block, faces);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t number = 0; number < 4; ++number) {
                if (!flat[axis][number]) continue;
                enter_flat_edge(rows[b], static_cast<int>(axis), number,
                                block.solve.flat_edge_exponent, exponents);
                for (const EdgeUse& use : rows[b][axis][number]) {
                    result[b].flat.push_back(
                        topology.edges[static_cast<std::size_t>(use.edge)].name);
                }
            }
        }
    }
    for (std::size_t b = 0; b < topology.blocks.size(); ++b) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t number = 0; number < 4; ++number) {
                const std::vector<EdgeUse>& row = rows[b][axis][number];
                result[b].exponents[axis][number] = {exponent_at(exponents, row, false),
                                                     exponent_at(exponents, row, true)};
            }
        }
    }
    return result;
}

}  // namespace hexweave
