// SPDX-License-Identifier: Apache-2.0
// One grid of the multigrid hierarchy: a face or block, or every second node of it, and the arrays
// that a cycle works on.
//
// Along i the nodes of a row are stored with the even ones first and the odd ones after them. So
// the nodes of one colour lie side by side, for vector instructions, and so do those of the next
// coarser grid. Along j and k the order is the usual one.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/field.h"
#include "core/large_pages.h"

namespace hexweave {

/// Nodes of one parity inside a row: `count` places from `first` on, boundary nodes and padding
/// included; each one's neighbours along i are stored `previous` and `next` away.
struct RowSegment {
    std::ptrdiff_t first = 0;
    int count = 0;
    std::ptrdiff_t previous = 0;
    std::ptrdiff_t next = 0;
};

/// How the nodes of a row are stored. Both halves are padded to whole vector registers, so that
/// loops over them have no remainder.
class RowShape {
public:
    RowShape() = default;
    explicit RowShape(int ni) : ni_(ni), even_(padded((ni + 1) / 2)), odd_(padded(ni / 2)) {}

    int nodes() const { return ni_; }
    int length() const { return even_ + odd_; }
    std::ptrdiff_t at(int i) const { return i % 2 == 0 ? i / 2 : even_ + i / 2; }
    std::array<RowSegment, 2> segments() const {
        return {RowSegment{0, even_, even_ - 1, even_}, RowSegment{even_, odd_, -even_, 1 - even_}};
    }

private:
    static constexpr int register_length = 8;
    static int padded(int count) {
        return (count + register_length - 1) / register_length * register_length;
    }

    int ni_ = 0;
    int even_ = 0;
    int odd_ = 0;
};

/// Several numbers for every node, all those of one row side by side; zero at first, and in the
/// padding.
template <class T>
class RowArray {
public:
    RowArray() = default;
    RowArray(const Extent& extent, int components)
        : shape_(extent.ni),
          nj_(extent.nj),
          components_(components),
          values_(static_cast<std::size_t>(extent.nk) * static_cast<std::size_t>(extent.nj) *
                      static_cast<std::size_t>(components * shape_.length()) +
                  overhang) {}

    /// Component 0 of row (j, k); the next ones follow at distances of one row length.
    T* row(int j, int k) { return values_.data() + offset(j, k); }
    const T* row(int j, int k) const { return values_.data() + offset(j, k); }
    std::ptrdiff_t stride_j() const {
        return static_cast<std::ptrdiff_t>(components_) * shape_.length();
    }
    std::ptrdiff_t stride_k() const { return stride_j() * nj_; }
    bool empty() const { return values_.empty(); }
    void clear() { std::fill(values_.begin(), values_.end(), T{}); }

private:
    /// The neighbours of the padding at the end of the last row.
    static constexpr std::size_t overhang = 16;

    std::ptrdiff_t offset(int j, int k) const { return j * stride_j() + k * stride_k(); }

    RowShape shape_;
    int nj_ = 0;
    int components_ = 0;
    std::vector<T, LargePages<T>> values_;
};

/// Calls visit(place in the finer row, place in the coarse row) for every node of a coarse row.
template <class Visit>
void for_coarse_nodes(const RowShape& finer, const RowShape& coarse, bool halved, Visit&& visit) {
    if (!halved) {
        for (std::ptrdiff_t p = 0; p < coarse.length(); ++p) visit(p, p);
        return;
    }
    // Coarse node i is the finer row's even node 2 i, which is stored at i; but for the last.
    const int last = coarse.nodes() - 1;
    const std::ptrdiff_t odd = coarse.segments()[1].first;
    for (std::ptrdiff_t m = 0; m < (last + 1) / 2; ++m) visit(2 * m, m);
    for (std::ptrdiff_t m = 0; m < last / 2; ++m) visit(2 * m + 1, odd + m);
    visit(finer.at(finer.nodes() - 1), coarse.at(last));
}

/// Where a node's numbers of the operator stand in Level::stencils, in the order of Stencil's
/// members: second[axis], mixed[plane], first[axis].
template <int axes>
struct StencilLayout {
    static constexpr int second = 0;
    static constexpr int mixed = axes;
    static constexpr int first = mixed + (axes == 3 ? 3 : 1);
    static constexpr int size = first + axes;
};

struct Level {
    Extent extent;
    int axes = 3;        ///< 2 for a face
    int components = 3;  ///< of the points; 2 for a face in a plane of constant z
    /// Along which axes this level holds every second node of the next finer one.
    std::array<bool, 3> halved{};
    RowShape shape;
    RowArray<double> points;
    RowArray<double> parameters;
    /// 9 numbers of the operator per node (5 on a face), its row scaled so that the centre is -1:
    /// second[axis], mixed[plane], first[axis] of Stencil.
    RowArray<float> stencils;
    /// Row scale of the operator: times this, an equation is integrated over its control volume in
    /// parameter space, and equations of different levels may be added.
    RowArray<float> weights;
    RowArray<float> residuals;
    RowArray<float> corrections;
    RowArray<double> right_hand_sides;  ///< integrated; on the finest level empty, and zero
    RowArray<float> steps;              ///< of the last cycle; on the finest level only

    int first_k() const { return axes == 3 ? 1 : 0; }
    int last_k() const { return axes == 3 ? extent.nk - 2 : 0; }
};

/// The coarse index's place on the finer level: every second node, and the last.
constexpr int finer_index(int coarse, int finer_count, bool halved) {
    if (!halved) return coarse;
    return 2 * coarse < finer_count - 1 ? 2 * coarse : finer_count - 1;
}

/// Nodes left of `count` when every second one is taken, the first and last always.
constexpr int halved_count(int count) {
    return count / 2 + 1;
}

/// Copies a field to component `component` of the rows, and back: all nodes or the interior ones.
void store(const Field& field, int component, RowArray<double>& rows);
void restore(const RowArray<double>& rows, int component, Field& field);
void restore_interior(const RowArray<double>& rows, int component, Field& field);

/// A level of every second node of `finer` along the axes `halved`, with the parameters of these
/// nodes; its points are not set yet.
Level coarser_level(const Level& finer, const std::array<bool, 3>& halved);

/// Copies the points (of `coarse`'s nodes) of the finer level to the coarser.
void inject_points(const Level& finer, Level& coarse);

}  // namespace hexweave
