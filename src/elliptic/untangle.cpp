// SPDX-License-Identifier: Apache-2.0
#include "elliptic/untangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "elliptic/fold_count.h"
#include "elliptic/node_lattice.h"
#include "elliptic/target_cells.h"
#include "elliptic/unfold.h"
#include "elliptic/untangle_patch.h"

namespace hexweave {

namespace {

/// Cells round a folded one whose nodes may move.
struct Margin {
    int across = 0;  ///< across its thin direction
    int along = 0;   ///< along it
};
/// The wider margin gives rounder cells; the narrower one is for grids so coarse that the wider
/// would move more than this share of their nodes.
constexpr Margin wide{2, 4};
constexpr Margin narrow{1, 3};
constexpr double wide_share = 0.015;
constexpr int most_rounds = 4;
/// Of grids with more than this share of their cells folded the rest is no better.
constexpr double most_folded_share = 0.05;
/// Patches with more than this share of the interior nodes are left to the whole grid.
constexpr double largest_share = 0.5;
/// About half a minute of work.
constexpr double whole_grid_node_visits = 1.5e8;
constexpr UnfoldLimits patch_limits{0.2, 25, 2, 1e7};
constexpr UnfoldLimits whole_grid_limits{0.5, 100, 5, whole_grid_node_visits};
constexpr double fewest_iterations = 50;

double edge_length(const PointField& x, const Node& from, int axis) {
    Node to = from;
    ++to[static_cast<std::size_t>(axis)];
    return distance(x(from[0], from[1], from[2]), x(to[0], to[1], to[2]));
}

/// The sum of a cell's edges along an axis.
double side_length(const PointField& x, const Node& cell, int axis) {
    const int axes = x.extent().nk == 1 ? 2 : 3;
    double sum = 0;
    for (int c = 0; c < (1 << axes); ++c) {
        if (((c >> axis) & 1) != 0) continue;
        sum +=
            edge_length(x, {cell[0] + (c & 1), cell[1] + ((c >> 1) & 1), cell[2] + (c >> 2)}, axis);
    }
    return sum;
}

int thin_axis_of(const PointField& x, const std::vector<FoldedCell>& cells) {
    const int axes = x.extent().nk == 1 ? 2 : 3;
    std::array<double, 3> logarithm{};
    for (const FoldedCell& cell : cells) {
        for (int axis = 0; axis < axes; ++axis) {
            logarithm[static_cast<std::size_t>(axis)] +=
                std::log(std::max(side_length(x, cell.cell, axis), 1e-300));
        }
    }
    return static_cast<int>(std::min_element(logarithm.begin(), logarithm.begin() + axes) -
                            logarithm.begin());
}

/// The region in which nodes may move, and the folded cells that it is for.
struct Region {
    Runs free;
    std::vector<FoldedCell> cells;
};

Node last_interior(const Extent& e) {
    return {e.ni - 2, e.nj - 2, e.nk == 1 ? 0 : e.nk - 2};
}
Node first_interior(const Extent& e) {
    return {1, 1, e.nk == 1 ? 0 : 1};
}

Runs all_interior(const Extent& e) {
    const Node low = first_interior(e);
    const Node high = last_interior(e);
    Runs runs;
    for (int k = low[2]; k <= high[2]; ++k) {
        for (int j = low[1]; j <= high[1]; ++j) runs.push_back({k, j, low[0], high[0]});
    }
    return runs;
}

/// Whether a node of the cell is in the set: one at least is in that of its own region.
bool holds_node_of(const Runs& runs, const Node& cell, const Extent& e) {
    Node n{};
    for (int axis = 0; axis < (e.nk == 1 ? 2 : 3); ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        n[a] = std::clamp(cell[a], 1, e[axis] - 2);
    }
    const std::size_t run = find_run(runs, n[0], n[1], n[2]);
    return run < runs.size() && runs[run].k == n[2] && runs[run].j == n[1] &&
           runs[run].first <= n[0];
}

/// Connected clusters of cells with a margin.
std::vector<Region> regions_of(const PointField& x, const std::vector<FoldedCell>& cells,
                               const Margin& margin) {
    const Extent& e = x.extent();
    std::array<Runs, 3> seeds;
    for (const FoldedCell& cell : cells) {
        const Node& n = cell.cell;
        const int thin = thin_axis_of(x, {cell});
        seeds[static_cast<std::size_t>(thin)].push_back({n[2], n[1], n[0], n[0]});
    }
    Runs all;
    for (std::size_t thin = 0; thin < 3; ++thin) {
        Reach reach;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int cells_beyond = axis == thin ? margin.along : margin.across;
            if (axis == 2 && e.nk == 1) continue;
            reach.below[axis] = cells_beyond - 1;
            reach.above[axis] = cells_beyond;
        }
        const Runs part =
            grown(merged(std::move(seeds[thin])), reach, first_interior(e), last_interior(e));
        all.insert(all.end(), part.begin(), part.end());
    }
    std::vector<Region> regions;
    for (Runs& free : connected_parts(merged(std::move(all)))) {
        regions.push_back({std::move(free), {}});
    }
    for (const FoldedCell& cell : cells) {
        for (Region& region : regions) {
            if (!holds_node_of(region.free, cell.cell, e)) continue;
            region.cells.push_back(cell);
            break;
        }
    }
    return regions;
}

/// Writes points to the grid, and what it held before to `before`.
class Moves {
public:
    void apply(const Patch& patch, PointField& points) {
        for (const int free : patch.free) {
            const auto n = static_cast<std::size_t>(free);
            before_.push_back({patch.nodes[n], points[patch.nodes[n]]});
            points.set(patch.nodes[n], patch.points[n]);
        }
    }

    /// How many points have moved since the first, how far, and where.
    void summarize(const PointField& points, Untangling& result) {
        std::stable_sort(before_.begin(), before_.end(),
                         [](const Old& a, const Old& b) { return a.node < b.node; });
        for (std::size_t m = 0; m < before_.size(); ++m) {
            if (m > 0 && before_[m].node == before_[m - 1].node) continue;
            const Vec3 now = points[before_[m].node];
            if (now == before_[m].point) continue;
            ++result.points_moved;
            const double move = distance(now, before_[m].point);
            if (move > result.largest_move) {
                result.largest_move = move;
                result.place = before_[m].point;
            }
        }
    }

    void undo(PointField& points) {
        for (std::size_t m = before_.size(); m-- > 0;) {
            points.set(before_[m].node, before_[m].point);
        }
        before_.clear();
    }

private:
    struct Old {
        std::size_t node = 0;
        Vec3 point;
    };
    std::vector<Old> before_;
};

std::vector<FoldedCell> curable(const std::vector<FoldedCell>& cells) {
    std::vector<FoldedCell> result;
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(result),
                 [](const FoldedCell& cell) { return !cell.by_boundary; });
    return result;
}

/// One round over all patches; returns the cells of patches that were not cured.
std::vector<FoldedCell> work_on_patches(PointField& points, std::vector<Region>& regions,
                                        const Vec3& plane, Moves& moves) {
    std::vector<Patch> patches(regions.size());
    std::vector<char> cured(regions.size(), 0);
    parallel_for(regions.size(), [&](std::size_t r) {
        patches[r] =
            make_patch(points, regions[r].free, thin_axis_of(points, regions[r].cells), plane);
        aim_at_sheared_cells(patches[r]);
        cured[r] = unfold(patches[r], patch_limits).folded == 0 ? 1 : 0;
    });
    std::vector<FoldedCell> left;
    for (std::size_t r = 0; r < regions.size(); ++r) {
        if (cured[r] != 0) {
            moves.apply(patches[r], points);
        } else {
            left.insert(left.end(), regions[r].cells.begin(), regions[r].cells.end());
        }
    }
    return left;
}

std::size_t count_free(const std::vector<Region>& regions) {
    std::size_t count = 0;
    for (const Region& region : regions) count += count_members(region.free);
    return count;
}

Margin first_margin(const PointField& points, const std::vector<FoldedCell>& cells) {
    const double share = static_cast<double>(count_free(regions_of(points, cells, wide))) /
                         static_cast<double>(points.extent().nodes());
    return share < wide_share ? wide : narrow;
}

/// Every interior node free, `start` for the points. Applied when fewer cells are folded than
/// `least` then.
bool work_on_whole_grid(PointField& points, const PointField& start, bool boxes, long& least,
                        Moves& moves) {
    const Vec3 plane = points.extent().nk == 1 ? plane_normal(points) : Vec3{};
    Patch patch = make_patch(start, all_interior(points.extent()),
                             thin_axis_of(points, curable(folded_cells(points))), plane);
    if (boxes) {
        aim_at_boxes(patch, points);
    } else {
        aim_at_sheared_cells(patch);
    }
    const Unfolding unfolding = unfold(patch, whole_grid_limits);
    if (unfolding.folded >= least) return false;
    least = unfolding.folded;
    moves.apply(patch, points);
    return true;
}

/// Larger and larger patches; returns the cells that they did not cure.
std::vector<FoldedCell> work_in_rounds(PointField& points, std::vector<FoldedCell> cells,
                                       Moves& moves, Untangling& result) {
    const Extent& e = points.extent();
    const double interior = static_cast<double>(count_members(all_interior(e)));
    if (static_cast<double>(cells.size()) > most_folded_share * static_cast<double>(e.cells())) {
        return cells;
    }
    const bool is_face = e.nk == 1;
    const Vec3 plane = is_face ? plane_normal(points) : Vec3{};
    const Margin margin = first_margin(points, cells);
    for (int round = 0; round < most_rounds && !cells.empty(); ++round) {
        std::vector<Region> regions =
            regions_of(points, cells, {margin.across << round, margin.along << round});
        if (static_cast<double>(count_free(regions)) > largest_share * interior) break;
        if (round == 0) result.patches = static_cast<int>(regions.size());
        result.rounds = round;
        cells = work_on_patches(points, regions, plane, moves);
        // Patches of a face in space are judged by the normals that they began with.
        if (is_face && plane == Vec3{}) cells = curable(folded_cells(points));
    }
    return cells;
}

}  // namespace

std::optional<Untangling> untangle(PointField& points,
                                   const std::function<PointField()>& transfinite) {
    std::vector<FoldedCell> cells = folded_cells(points);
    if (cells.empty()) return std::nullopt;
    Untangling result;
    result.folded_before = static_cast<long>(cells.size());
    const double interior = NodeLattice(points.extent()).has_interior()
                                ? static_cast<double>(count_members(all_interior(points.extent())))
                                : 0;
    Moves moves;
    cells = curable(cells);
    const bool some_beyond_cure = static_cast<long>(cells.size()) < result.folded_before;
    if (interior > 0 && !cells.empty()) cells = work_in_rounds(points, cells, moves, result);
    if (interior > 0 && !cells.empty() && interior * fewest_iterations < whole_grid_node_visits) {
        auto left = static_cast<long>(cells.size());
        result.whole_grid = work_on_whole_grid(points, points, false, left, moves);
        if (left > 0) {
            result.whole_grid |= work_on_whole_grid(points, transfinite(), true, left, moves);
        }
    }
    // Cured patches of blocks are known to be; a face costs nothing, and one in space was judged by
    // other normals.
    if (!cells.empty() || some_beyond_cure || points.extent().nk == 1) {
        cells = folded_cells(points);
        if (static_cast<long>(cells.size()) > result.folded_before) {
            moves.undo(points);
            cells = folded_cells(points);
        }
    }
    if (!cells.empty()) {
        const Node& cell = cells.front().cell;
        result.left_at = points(cell[0], cell[1], cell[2]);
    }
    moves.summarize(points, result);
    return result;
}

}  // namespace hexweave
