// SPDX-License-Identifier: Apache-2.0
#include "faces/harmonic_iteration.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "elliptic/best_iterate.h"
#include "elliptic/fold_count.h"
#include "elliptic/laplace_solver.h"
#include "elliptic/untangle.h"
#include "faces/transfinite_face.h"

namespace hexweave {

namespace {

/// The harmonic functions' accuracy in shares of that of the grid, both in cells.
constexpr double share_of_tolerance = 1e-2;

/// One pass; false where the harmonic functions were not found.
bool make_pass(PointField& points, const ParameterField& parameters, double tolerance,
               const BoundFace& face, SolveResult& result) {
    const LaplaceHierarchy hierarchy(element_conductances(points));
    // What they are to be is what they are, in the end.
    Field s = parameters.s;
    Field t = parameters.t;
    bool solved = true;
    for (Field* field : {&s, &t}) {
        const LaplaceResult found = solve_laplace(
            hierarchy, {true, true, true, true},
            {share_of_tolerance * tolerance, LaplaceOptions().maximum_cycles}, *field);
        result.cycles += found.cycles;
        solved = solved && found.converged;
    }
    if (!solved) return false;
    result.displacement = face.move(points, s, t, parameters);
    if (!result.history.empty()) result.rate = result.displacement / result.history.back();
    result.history.push_back(result.displacement);
    return true;
}

/// What untangling came to over several rounds, from the grid before them to the one after.
void summarize(const PointField& before, const PointField& after, Untangling& result) {
    for (std::size_t n = 0; n < before.extent().nodes(); ++n) {
        const double move = distance(before[n], after[n]);
        if (move == 0) continue;
        ++result.points_moved;
        if (move <= result.largest_move) continue;
        result.largest_move = move;
        result.place = before[n];
    }
    const std::vector<FoldedCell> left = folded_cells(after);
    if (left.empty()) return;
    const Node& cell = left.front().cell;
    result.left_at = after(cell[0], cell[1]);
}

}  // namespace

SolveResult solve_bound(PointField& points, const ParameterField& parameters,
                        const EllipticOptions& options, const BoundFace& face) {
    constexpr int patience = 5;  // passes without progress
    SolveResult result;
    result.tolerance = options.tolerance;
    result.folded_before = count_folded(points);
    const Extent e = points.extent();
    if (e.ni < 3 || e.nj < 3) {
        result.status = SolveStatus::converged;
        result.folded_after = result.folded_before;
        return result;
    }
    result.status = SolveStatus::not_converged;
    face.keep(points);
    result.kept_cycle = 0;
    IterateRank best{result.folded_before};
    double least = INFINITY;
    int idle = 0;
    for (int pass = 0; pass < options.maximum_cycles && idle < patience; ++pass) {
        if (!make_pass(points, parameters, options.tolerance, face, result)) break;
        idle = result.displacement < least ? 0 : idle + 1;
        least = std::min(least, result.displacement);
        const IterateRank rank{count_folded(points), result.displacement};
        if (rank < best) {
            best = rank;
            face.keep(points);
            result.kept_cycle = pass + 1;
        }
        const double remaining = result.rate > 0 && result.rate < 1
                                     ? result.displacement * result.rate / (1 - result.rate)
                                     : result.displacement;
        if (remaining < options.tolerance) {
            result.status = SolveStatus::converged;
            break;
        }
    }
    if (result.status == SolveStatus::converged) {
        result.kept_cycle.reset();
    } else {
        face.restore(points);
    }
    result.folded_after = count_folded(points);
    return result;
}

std::optional<Untangling> untangle_bound(PointField& points, const ParameterField& parameters,
                                         const BoundFace& face) {
    constexpr int most_rounds = 5;
    Untangling all;
    all.folded_before = count_folded(points);
    if (all.folded_before == 0) return std::nullopt;
    const PointField before = points;
    long folded = all.folded_before;
    for (int round = 0; round < most_rounds && folded > 0; ++round) {
        face.keep(points);
        const std::optional<Untangling> step = untangle(points, [&] {
            PointField transfinite = points;
            interpolate_face(transfinite, parameters);
            return transfinite;
        });
        face.project(points);
        const long left = count_folded(points);
        if (left >= folded) {
            face.restore(points);
            break;
        }
        folded = left;
        all.rounds = round;
        if (!step) continue;
        all.patches += step->patches;
        all.whole_grid = all.whole_grid || step->whole_grid;
    }
    summarize(before, points, all);
    return all;
}

}  // namespace hexweave
