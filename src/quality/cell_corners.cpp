// SPDX-License-Identifier: Apache-2.0
#include "quality/cell_corners.h"

#include <cmath>
#include <cstddef>

#include "elliptic/fold_count.h"

namespace hexweave {

namespace {

/// Where two sides of a zone meet at more than 150 degrees, a corner may be flat.
const double flat_cosine = std::cos(150.0 / 180.0 * std::acos(-1.0));

double scaled(double value, double scale) {
    return scale > 0 ? value / scale : 0;
}

/// The direction that leads from a corner node into its cell along an axis: +1 at the low end.
using Inward = std::array<int, 3>;

Vec3 leg(const PointField& x, const Node& corner, const Inward& inward, int axis) {
    Node other = corner;
    other[static_cast<std::size_t>(axis)] += inward[static_cast<std::size_t>(axis)];
    return x(other[0], other[1], other[2]) - x(corner[0], corner[1], corner[2]);
}

bool on_side(const Node& node, const Extent& extent, int axis) {
    const int index = node[static_cast<std::size_t>(axis)];
    return extent[axis] > 1 && (index == 0 || index == extent[axis] - 1);
}

/// Whether the two sides that meet at this corner along the zone edge `edge` (a zero vector in two
/// dimensions) do so at more than 150 degrees, seen along that edge.
bool sides_meet_flat(Vec3 a, Vec3 b, const Vec3& edge) {
    const double length = dot(edge, edge);
    if (length > 0) {
        a -= (dot(a, edge) / length) * edge;
        b -= (dot(b, edge) / length) * edge;
    }
    const double scale = norm(a) * norm(b);
    return scale > 0 && dot(a, b) < flat_cosine * scale;
}

/// Whether one of the zone's edges through this node (its corner, on a surface) is a flat one.
bool may_be_flat(const Node& node, const Extent& extent, const std::array<Vec3, 3>& legs) {
    if (extent.nk == 1) {
        return on_side(node, extent, 0) && on_side(node, extent, 1) &&
               sides_meet_flat(legs[0], legs[1], {});
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t first = (axis + 1) % 3;
        const std::size_t second = (axis + 2) % 3;
        if (on_side(node, extent, static_cast<int>(first)) &&
            on_side(node, extent, static_cast<int>(second)) &&
            sides_meet_flat(legs[first], legs[second], legs[axis])) {
            return true;
        }
    }
    return false;
}

/// Whether a corner lies at a pole: a leg along a side of the zone has no length.
bool is_at_pole(const Node& node, const Extent& extent, const std::array<Vec3, 3>& legs) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(legs[static_cast<std::size_t>(axis)] == Vec3{}) || extent[axis] == 1) continue;
        for (int other = 0; other < 3; ++other) {
            if (other != axis && on_side(node, extent, other)) return true;
        }
    }
    return false;
}

/// The unit normal that a surface cell's corners are measured against; zero for a cell without
/// area.
Vec3 surface_normal(const PointField& x, const Node& cell, const Vec3& plane) {
    if (!(plane == Vec3{})) return plane;
    const int i = cell[0];
    const int j = cell[1];
    const Vec3 normal = cross(x(i + 1, j + 1) - x(i, j), x(i, j + 1) - x(i + 1, j));
    const double length = norm(normal);
    return length > 0 ? normal / length : Vec3{};
}

CellCorner corner_of(const PointField& x, const Node& cell, int c, const Vec3& normal) {
    const Extent extent = x.extent();
    const int axes = extent.nk == 1 ? 2 : 3;
    CellCorner corner;
    corner.node = cell;
    Inward inward{1, 1, 1};
    for (int axis = 0; axis < axes; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const int high = (c >> axis) & 1;
        corner.node[a] += high;
        inward[a] = 1 - 2 * high;
    }
    std::array<Vec3, 3> legs;
    double lengths = 1;
    for (int axis = 0; axis < axes; ++axis) {
        legs[static_cast<std::size_t>(axis)] = leg(x, corner.node, inward, axis);
        lengths *= norm(legs[static_cast<std::size_t>(axis)]);
    }
    const double sign = inward[0] * inward[1] * inward[2];
    corner.jacobian = sign * triple(legs[0], legs[1], axes == 2 ? normal : legs[2]);
    corner.scaled_jacobian = scaled(corner.jacobian, lengths);
    corner.inside = !on_side(corner.node, extent, 0) && !on_side(corner.node, extent, 1) &&
                    !on_side(corner.node, extent, 2);
    if (corner.inside) return corner;
    corner.at_pole = is_at_pole(corner.node, extent, legs);
    corner.flat = !corner.at_pole && std::abs(corner.scaled_jacobian) <= fold_limit &&
                  may_be_flat(corner.node, extent, legs);
    return corner;
}

}  // namespace

bool CellCorner::folds() const {
    return !counted_apart() && !(scaled_jacobian > fold_limit);
}

Vec3 zone_plane(const PointField& points, int physical_dimension) {
    constexpr double single_precision = 1e-6;
    if (points.extent().nk > 1) return {};
    return physical_dimension == 2 ? Vec3{0, 0, 1} : plane_normal(points, single_precision);
}

CellCorners cell_corners(const PointField& x, const Node& cell, const Vec3& plane) {
    const bool is_surface = x.extent().nk == 1;
    const Vec3 normal = is_surface ? surface_normal(x, cell, plane) : Vec3{};
    CellCorners result;
    result.count = is_surface ? 4 : 8;
    for (int c = 0; c < result.count; ++c) {
        result.corners[static_cast<std::size_t>(c)] = corner_of(x, cell, c, normal);
    }
    return result;
}

}  // namespace hexweave
