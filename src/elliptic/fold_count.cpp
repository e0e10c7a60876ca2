// SPDX-License-Identifier: Apache-2.0
#include "elliptic/fold_count.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/parallel.h"

namespace hexweave {

namespace {

/// The cosine of 150 degrees, squared; the cosine itself is negative.
constexpr double squared_flat_cosine = 0.75;

bool on_side(const Node& node, const Extent& extent, int axis) {
    const int index = node[static_cast<std::size_t>(axis)];
    return index == 0 || index == extent[axis] - 1;
}

bool on_boundary(const Node& node, const Extent& extent) {
    return on_side(node, extent, 0) || on_side(node, extent, 1) ||
           (extent.nk > 1 && on_side(node, extent, 2));
}

/// Whether a and b, seen along `edge` (zero on a face), enclose more than 150 degrees.
bool meet_flat(Vec3 a, Vec3 b, const Vec3& edge) {
    const double length = dot(edge, edge);
    if (length > 0) {
        a -= (dot(a, edge) / length) * edge;
        b -= (dot(b, edge) / length) * edge;
    }
    const double product = dot(a, b);
    return product < 0 && product * product > squared_flat_cosine * dot(a, a) * dot(b, b);
}

/// One corner of a cell: its node and the edges that leave it within the cell.
struct Corner {
    Node node{};
    int sign = 1;  ///< of the determinant of the legs in a sound cell
    std::array<Vec3, 3> legs{};
    std::array<bool, 3> fixed{};  ///< the leg joins two boundary nodes
};

/// Corner c of a cell: bit a of c is set at the high end of axis a.
Corner corner_of(const PointField& x, const Node& cell, int c) {
    const Extent& extent = x.extent();
    const int axes = extent.nk == 1 ? 2 : 3;
    Corner corner{cell, 1, {}, {}};
    for (int axis = 0; axis < axes; ++axis) {
        corner.node[static_cast<std::size_t>(axis)] += (c >> axis) & 1;
    }
    const bool fixed = on_boundary(corner.node, extent);
    for (int axis = 0; axis < axes; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const int inward = ((c >> axis) & 1) == 0 ? 1 : -1;
        Node other = corner.node;
        other[a] += inward;
        corner.sign *= inward;
        corner.legs[a] =
            x(other[0], other[1], other[2]) - x(corner.node[0], corner.node[1], corner.node[2]);
        corner.fixed[a] = fixed && on_boundary(other, extent);
    }
    return corner;
}

bool is_sound(const Corner& corner, int axes, const Vec3& normal) {
    const Vec3& a = corner.legs[0];
    const Vec3& b = corner.legs[1];
    if (axes == 2) {
        return is_sound_corner(corner.sign * triple(a, b, normal),
                               dot(a, a) * dot(b, b) * dot(normal, normal));
    }
    const Vec3& c = corner.legs[2];
    return is_sound_corner(corner.sign * triple(a, b, c), dot(a, a) * dot(b, b) * dot(c, c));
}

/// Whether a corner lies at a pole: a leg within the grid's boundary has no length.
bool is_at_pole(const Corner& corner, int axes) {
    for (std::size_t a = 0; a < static_cast<std::size_t>(axes); ++a) {
        if (corner.fixed[a] && corner.legs[a] == Vec3{}) return true;
    }
    return false;
}

/// Whether a corner that is not sound is flat where the grid's sides meet flat, or lies at a pole.
bool is_excused(const Corner& corner, const Extent& extent, int axes, const Vec3& normal) {
    if (is_at_pole(corner, axes)) return true;
    Corner turned = corner;
    turned.sign = -corner.sign;
    if (is_sound(turned, axes, normal)) return false;  // inside out, not flat
    const auto& legs = corner.legs;
    if (axes == 2) {
        return on_side(corner.node, extent, 0) && on_side(corner.node, extent, 1) &&
               meet_flat(legs[0], legs[1], {});
    }
    for (int axis = 0; axis < 3; ++axis) {
        const int first = (axis + 1) % 3;
        const int second = (axis + 2) % 3;
        if (on_side(corner.node, extent, first) && on_side(corner.node, extent, second) &&
            meet_flat(legs[static_cast<std::size_t>(first)], legs[static_cast<std::size_t>(second)],
                      legs[static_cast<std::size_t>(axis)])) {
            return true;
        }
    }
    return false;
}

/// Whether a folded corner stays folded wherever the interior nodes go: its legs between boundary
/// nodes alone have no volume, area or length.
bool is_beyond_cure(const Corner& corner, int axes) {
    std::vector<Vec3> fixed;
    for (int axis = 0; axis < axes; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        if (corner.fixed[a]) fixed.push_back(corner.legs[a]);
    }
    if (static_cast<int>(fixed.size()) == axes) return true;
    if (fixed.size() == 2) {
        const Vec3 area = cross(fixed[0], fixed[1]);
        return !(dot(area, area) >
                 fold_limit * fold_limit * dot(fixed[0], fixed[0]) * dot(fixed[1], fixed[1]));
    }
    return fixed.size() == 1 && !(dot(fixed[0], fixed[0]) > 0);
}

struct CellState {
    bool folded = false;
    bool by_boundary = false;
};

/// The exact rule, for the few cells that the quick test does not pass.
CellState cell_state(const PointField& x, const Node& cell, const Vec3& plane) {
    const Extent& extent = x.extent();
    const int axes = extent.nk == 1 ? 2 : 3;
    Vec3 normal = plane;
    if (axes == 2 && normal == Vec3{}) {
        const int i = cell[0];
        const int j = cell[1];
        normal = cross(x(i + 1, j + 1) - x(i, j), x(i, j + 1) - x(i + 1, j));
    }
    CellState state;
    for (int c = 0; c < (axes == 2 ? 4 : 8); ++c) {
        const Corner corner = corner_of(x, cell, c);
        if (is_sound(corner, axes, normal) || is_excused(corner, extent, axes, normal)) continue;
        state.folded = true;
        state.by_boundary |= is_beyond_cure(corner, axes);
    }
    return state;
}

/// The four nodes of a cell in one plane of constant i, (j, k) = (0,0), (1,0), (0,1), (1,1), and
/// what the quick test needs of them.
struct CellPlane {
    std::array<Vec3, 4> node;
    std::array<Vec3, 4> normal;  ///< at each node: j-edge cross k-edge
    double size = 0;             ///< squared lengths of the four edges

    CellPlane(const std::array<std::size_t, 4>& rows, std::size_t i, const PointField& x)
        : node{x[rows[0] + i], x[rows[1] + i], x[rows[2] + i], x[rows[3] + i]} {
        const std::array<Vec3, 2> along_j{node[1] - node[0], node[3] - node[2]};
        const std::array<Vec3, 2> along_k{node[2] - node[0], node[3] - node[1]};
        for (std::size_t c = 0; c < 4; ++c) normal[c] = cross(along_j[c / 2], along_k[c % 2]);
        size = dot(along_j[0], along_j[0]) + dot(along_j[1], along_j[1]) +
               dot(along_k[0], along_k[0]) + dot(along_k[1], along_k[1]);
    }
};

/// Sound by far: the least determinant against the largest product of lengths that edges of this
/// total size can have. Flat and folded cells, and NaN, do not pass.
bool surely_sound(const CellPlane& low, const CellPlane& high) {
    double size = low.size + high.size;
    std::array<double, 8> determinant{};
    for (std::size_t c = 0; c < 4; ++c) {
        const Vec3 along_i = high.node[c] - low.node[c];
        size += dot(along_i, along_i);
        determinant[c] = dot(along_i, low.normal[c]);
        determinant[c + 4] = dot(along_i, high.normal[c]);
    }
    double least = determinant[0];
    for (const double d : determinant) least = d < least ? d : least;
    return is_sound_corner(least, size * size * size / 27);
}

template <class Visit>
void visit_block_layer(const PointField& x, int k, Visit&& visit) {
    const Extent& e = x.extent();
    for (int j = 0; j + 1 < e.nj; ++j) {
        const std::array<std::size_t, 4> rows{e.offset(0, j, k), e.offset(0, j + 1, k),
                                              e.offset(0, j, k + 1), e.offset(0, j + 1, k + 1)};
        CellPlane low(rows, 0, x);
        for (int i = 0; i + 1 < e.ni; ++i) {
            const CellPlane high(rows, static_cast<std::size_t>(i) + 1, x);
            if (!surely_sound(low, high)) {
                const CellState state = cell_state(x, {i, j, k}, {});
                if (state.folded) visit(FoldedCell{{i, j, k}, state.by_boundary});
            }
            low = high;
        }
    }
}

/// The same of a face's cell with the corners p00, p10, p01, p11, against `plane` or, where that is
/// zero, the cell's own normal.
bool surely_sound(const Vec3& p00, const Vec3& p10, const Vec3& p01, const Vec3& p11,
                  const Vec3& plane) {
    const Vec3 low = p10 - p00;
    const Vec3 high = p11 - p01;
    const Vec3 left = p01 - p00;
    const Vec3 right = p11 - p10;
    const Vec3 normal = plane == Vec3{} ? cross(p11 - p00, p01 - p10) : plane;
    const double least =
        std::min(std::min(triple(low, left, normal), triple(low, right, normal)),
                 std::min(triple(high, left, normal), triple(high, right, normal)));
    const double along = dot(low, low) + dot(high, high);
    const double across = dot(left, left) + dot(right, right);
    return is_sound_corner(least, along * across * dot(normal, normal));
}

template <class Visit>
void visit_face_row(const PointField& x, const Vec3& plane, int j, Visit&& visit) {
    Vec3 low = x(0, j);
    Vec3 high = x(0, j + 1);
    for (int i = 0; i + 1 < x.extent().ni; ++i) {
        const Vec3 next_low = x(i + 1, j);
        const Vec3 next_high = x(i + 1, j + 1);
        if (!surely_sound(low, next_low, high, next_high, plane)) {
            const CellState state = cell_state(x, {i, j, 0}, plane);
            if (state.folded) visit(FoldedCell{{i, j, 0}, state.by_boundary});
        }
        low = next_low;
        high = next_high;
    }
}

/// Calls visit(layer, cell) for every folded cell; layers in parallel, each in order.
template <class Visit>
void visit_folded(const PointField& x, Visit&& visit) {
    const Extent& e = x.extent();
    if (e.nk == 1) {
        const Vec3 plane = plane_normal(x);
        parallel_for(static_cast<std::size_t>(e.nj - 1), [&](std::size_t j) {
            visit_face_row(x, plane, static_cast<int>(j),
                           [&](const FoldedCell& cell) { visit(j, cell); });
        });
    } else {
        parallel_for(static_cast<std::size_t>(e.nk - 1), [&](std::size_t k) {
            visit_block_layer(x, static_cast<int>(k),
                              [&](const FoldedCell& cell) { visit(k, cell); });
        });
    }
}

std::size_t layers(const Extent& e) {
    return static_cast<std::size_t>(e.nk == 1 ? e.nj - 1 : e.nk - 1);
}

/// Twice the area that the boundary of a face encloses, as a vector.
Vec3 boundary_area(const PointField& x) {
    const Extent& e = x.extent();
    const Vec3 origin = x[0];
    Vec3 area;
    const auto add = [&](const Vec3& a, const Vec3& b) { area += cross(a - origin, b - origin); };
    for (int i = 0; i + 1 < e.ni; ++i) {
        add(x(i, 0), x(i + 1, 0));
        add(x(i + 1, e.nj - 1), x(i, e.nj - 1));
    }
    for (int j = 0; j + 1 < e.nj; ++j) {
        add(x(e.ni - 1, j), x(e.ni - 1, j + 1));
        add(x(0, j + 1), x(0, j));
    }
    return area;
}

}  // namespace

Vec3 plane_normal(const PointField& face, double thickness) {
    const Vec3 area = boundary_area(face);
    const double size = norm(area);
    if (!(size > 0)) return {};
    const std::size_t nodes = face.extent().nodes();
    const bool level =
        std::all_of(face.z.data(), face.z.data() + nodes, [&](double z) { return z == face.z[0]; });
    if (level) return {0, 0, area.z > 0 ? 1.0 : -1.0};
    const Vec3 normal = area / size;
    for (std::size_t p = 0; p < nodes; ++p) {
        if (!(std::abs(dot(face[p] - face[0], normal)) <= thickness * std::sqrt(size))) return {};
    }
    return normal;
}

long count_folded(const PointField& points) {
    std::vector<long> counts(layers(points.extent()));
    visit_folded(points, [&](std::size_t layer, const FoldedCell&) { ++counts[layer]; });
    long folded = 0;
    for (const long count : counts) folded += count;
    return folded;
}

std::vector<FoldedCell> folded_cells(const PointField& points) {
    std::vector<std::vector<FoldedCell>> found(layers(points.extent()));
    visit_folded(points,
                 [&](std::size_t layer, const FoldedCell& cell) { found[layer].push_back(cell); });
    std::vector<FoldedCell> all;
    for (const auto& cells : found) all.insert(all.end(), cells.begin(), cells.end());
    return all;
}

std::vector<FoldedCell> still_folded(const PointField& points,
                                     const std::vector<FoldedCell>& cells) {
    const Vec3 plane = points.extent().nk == 1 ? plane_normal(points) : Vec3{};
    std::vector<FoldedCell> folded;
    for (const FoldedCell& cell : cells) {
        if (cell_state(points, cell.cell, plane).folded) folded.push_back(cell);
    }
    return folded;
}

}  // namespace hexweave
