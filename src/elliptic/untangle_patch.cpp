// SPDX-License-Identifier: Apache-2.0
#include "elliptic/untangle_patch.h"

#include <algorithm>

#include "elliptic/fold_count.h"

namespace hexweave {

namespace {

/// The normal of a face cell in space, from the corners of a window of cells about it: folds within
/// the window do not turn it.
Vec3 window_normal(const PointField& x, int i, int j) {
    constexpr int reach = 3;
    const Extent& e = x.extent();
    const int i0 = std::max(0, i - reach);
    const int j0 = std::max(0, j - reach);
    const int i1 = std::min(e.ni - 1, i + 1 + reach);
    const int j1 = std::min(e.nj - 1, j + 1 + reach);
    const Vec3 normal = cross(x(i1, j1) - x(i0, j0), x(i0, j1) - x(i1, j0));
    const double length = norm(normal);
    return length > 0 ? normal / length : Vec3{};
}

/// Calls visit(position, i, j, k) for every member, in order.
template <class Visit>
void for_members(const Runs& runs, Visit&& visit) {
    std::size_t position = 0;
    for (const Run& run : runs) {
        for (int i = run.first; i <= run.last; ++i) visit(position++, i, run.j, run.k);
    }
}

/// The number of member (i, j, k) of a set that holds it.
struct Numbering {
    const Runs& runs;
    std::vector<int> starts;

    explicit Numbering(const Runs& r) : runs(r), starts(run_starts(r)) {}

    /// Added to i it is the number of (i, j, k), as for all members of the run that holds `near`.
    int base(int near, int j, int k) const {
        const std::size_t run = find_run(runs, near, j, k);
        return starts[run] - runs[run].first;
    }
};

void number_cells(const Runs& cells, const Numbering& nodes, Patch& patch) {
    patch.cells.reserve(count_members(cells));
    for (const Run& run : cells) {
        std::array<int, 4> base{};
        for (int c = 0; c < (patch.axes == 3 ? 4 : 2); ++c) {
            base[static_cast<std::size_t>(c)] =
                nodes.base(run.first, run.j + (c & 1), run.k + (c >> 1));
        }
        for (int i = run.first; i <= run.last; ++i) {
            std::array<int, 8> cell{};
            for (std::size_t c = 0; c < cell.size(); ++c) {
                cell[c] = base[c >> 1] + i + static_cast<int>(c & 1);
            }
            patch.cells.push_back(cell);
        }
    }
}

/// Layers along the slowest axis, two to a slab: cells of every second slab share no node.
void divide_into_slabs(const Runs& cells, Patch& patch) {
    constexpr int layers = 2;
    std::size_t count = 0;
    int next = -1;
    for (const Run& run : cells) {
        const int layer = patch.axes == 3 ? run.k : run.j;
        if (next < 0 || layer >= next) {
            patch.slabs.push_back(count);
            next = layer + layers;
        }
        count += static_cast<std::size_t>(run.length());
    }
    patch.slabs.push_back(count);
}

void find_couplings(const Runs& free, const Numbering& nodes, Patch& patch) {
    const std::size_t couplings = patch.couplings();
    patch.ahead.assign(patch.free.size() * couplings, -1);
    patch.behind.assign(patch.free.size() * couplings, -1);
    std::size_t own = 0;
    for (const Run& run : free) {
        for (std::size_t c = 0; c < couplings; ++c) {
            const Node& d = nodes_ahead[c];
            const int base = nodes.base(run.first, run.j + d[1], run.k + d[2]) + d[0];
            for (int i = run.first; i <= run.last; ++i) {
                const std::size_t f = own + static_cast<std::size_t>(i - run.first);
                const int node = base + i;
                const int other = patch.free_of[static_cast<std::size_t>(node)];
                patch.ahead[f * couplings + c] = other;
                if (other >= 0) {
                    patch.behind[static_cast<std::size_t>(other) * couplings + c] =
                        static_cast<int>(f);
                }
            }
        }
        own += static_cast<std::size_t>(run.length());
    }
}

}  // namespace

Patch make_patch(const PointField& points, const Runs& free, int thin_axis, const Vec3& plane) {
    const Extent& e = points.extent();
    Patch patch;
    patch.axes = e.nk == 1 ? 2 : 3;
    patch.thin_axis = thin_axis;
    const int k_step = patch.axes == 3 ? 1 : 0;
    const Node last{e.ni - 1, e.nj - 1, e.nk - 1};
    const Runs cells = grown(free, {{1, 1, k_step}, {}}, {}, last);
    const Runs nodes = grown(cells, {{}, {1, 1, k_step}}, {}, last);
    const Numbering node_numbers(nodes);

    const std::size_t count = count_members(nodes);
    patch.nodes.resize(count);
    patch.points.resize(count);
    patch.free_of.assign(count, -1);
    for_members(nodes, [&](std::size_t n, int i, int j, int k) {
        patch.nodes[n] = e.offset(i, j, k);
        patch.points[n] = points[patch.nodes[n]];
    });
    patch.free.resize(count_members(free));
    for (std::size_t f = 0; const Run& run : free) {
        const int base = node_numbers.base(run.first, run.j, run.k);
        for (int i = run.first; i <= run.last; ++i, ++f) {
            const int node = base + i;
            patch.free[f] = node;
            patch.free_of[static_cast<std::size_t>(node)] = static_cast<int>(f);
        }
    }
    number_cells(cells, node_numbers, patch);
    divide_into_slabs(cells, patch);
    find_couplings(free, node_numbers, patch);
    if (patch.axes == 2) {
        patch.normals.resize(patch.cells.size());
        for_members(cells, [&](std::size_t c, int i, int j, int) {
            patch.normals[c] = plane == Vec3{} ? window_normal(points, i, j) : plane;
        });
    }
    return patch;
}

long count_folded(const Patch& patch) {
    const int corners = patch.corners();
    long folded = 0;
    for (std::size_t cell = 0; cell < patch.cells.size(); ++cell) {
        for (int c = 0; c < corners; ++c) {
            const std::size_t t =
                cell * static_cast<std::size_t>(corners) + static_cast<std::size_t>(c);
            if (patch.targets[t].inverse_volume == 0) continue;
            const auto legs = corner_legs(patch, cell, c);
            if (!is_sound_corner(
                    corner_sign(c, patch.axes) * triple(legs[0], legs[1], legs[2]),
                    dot(legs[0], legs[0]) * dot(legs[1], legs[1]) * dot(legs[2], legs[2]))) {
                ++folded;
                break;
            }
        }
    }
    return folded;
}

}  // namespace hexweave
