// SPDX-License-Identifier: Apache-2.0
#include "faces/orthogonal_face.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "core/orientation.h"
#include "elliptic/laplace_solver.h"

namespace hexweave {

namespace {

/// So many passes more are made as long as edge functions had to be kept increasing: the less the
/// cells slant, the less they have to.
constexpr int passes_more = 4;

/// The edge functions' accuracy in shares of that of the grid, both in cells.
constexpr double share_of_tolerance = 1e-2;

/// The values along a side of a face, in index order.
std::vector<double> along_side(const Field& values, Side side) {
    const Extent e = values.extent();
    std::vector<double> line;
    if (axis_of(side) == 0) {
        for (int j = 0; j < e.nj; ++j) line.push_back(values(is_max(side) ? e.ni - 1 : 0, j));
    } else {
        for (int i = 0; i < e.ni; ++i) line.push_back(values(i, is_max(side) ? e.nj - 1 : 0));
    }
    return line;
}

/// The harmonic functions increase along an edge; across very slanting cells discrete ones may not.
/// There an interval keeps `least_share` of what it had, and all are scaled to reach from 0 to 1.
/// Returns how many intervals that are.
int make_increasing(const std::vector<double>& before, std::vector<double>& line) {
    constexpr double least_share = 0.2;
    int limited = 0;
    std::vector<double> sums{0};
    for (std::size_t n = 1; n < line.size(); ++n) {
        const double least = least_share * (before[n] - before[n - 1]);
        const double interval = line[n] - line[n - 1];
        if (interval < least) ++limited;
        sums.push_back(sums.back() + std::max(interval, least));
    }
    if (limited == 0) return 0;
    for (std::size_t n = 1; n < line.size(); ++n) line[n] = sums[n] / sums.back();
    return limited;
}

/// A grid may stand for the user's only if it converged and no cell is folded.
OrthogonalityEnd fault_of(const SolveResult& solve) {
    if (solve.status != SolveStatus::converged) return OrthogonalityEnd::not_converged;
    if (solve.folded_after > 0) return OrthogonalityEnd::folded;
    return OrthogonalityEnd::all_passes;
}

/// The record of one more solve from the grid that another left.
SolveResult continued(SolveResult before, const SolveResult& next) {
    SolveResult both = next;
    both.folded_before = before.folded_before;
    if (!both.untangling) both.untangling = std::move(before.untangling);
    both.cycles += before.cycles;
    both.history = std::move(before.history);
    both.history.insert(both.history.end(), next.history.begin(), next.history.end());
    both.safeguards = std::move(before.safeguards);
    for (const Safeguard safeguard : next.safeguards) {
        if (std::find(both.safeguards.begin(), both.safeguards.end(), safeguard) ==
            both.safeguards.end()) {
            both.safeguards.push_back(safeguard);
        }
    }
    return both;
}

}  // namespace

HarmonicEdges harmonic_edges(const PointField& points, const ParameterField& parameters,
                             const std::array<bool, 4>& orthogonal, double tolerance) {
    HarmonicEdges edges;
    const LaplaceHierarchy hierarchy(points);
    const auto solve = [&](const Field& start, bool is_s) {
        Field values = start;
        const std::size_t first = is_s ? 2 : 0;
        if (orthogonal[first] || orthogonal[first + 1]) {
            std::array<bool, 4> fixed{true, true, true, true};
            fixed[first] = !orthogonal[first];
            fixed[first + 1] = !orthogonal[first + 1];
            const LaplaceResult result = solve_laplace(
                hierarchy, fixed, {tolerance, LaplaceOptions().maximum_cycles}, values);
            edges.cycles += result.cycles;
            if (!result.converged) edges.end = OrthogonalityEnd::edges_not_converged;
        }
        for (const std::size_t side : {first, first + 1}) {
            edges.functions[side] = along_side(values, static_cast<Side>(side));
            edges.limited +=
                make_increasing(along_side(start, static_cast<Side>(side)), edges.functions[side]);
        }
    };
    solve(parameters.s, true);
    solve(parameters.t, false);
    return edges;
}

int orthogonal_passes(const std::array<bool, 4>& orthogonal,
                      const std::array<bool, 4>& flat_corners) {
    const auto& [imin, imax, jmin, jmax] = orthogonal;
    const std::array<bool, 4> marked{imin || jmin, imax || jmin, imax || jmax, imin || jmax};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        if (marked[corner] && flat_corners[corner]) return 1;
    }
    return 2;
}

void make_orthogonal(PointField& points, ParameterField parameters,
                     const std::array<bool, 4>& orthogonal, int passes,
                     const EllipticOptions& options, SolveResult& result, const FaceSolver& solve) {
    Orthogonality record;
    record.passes_asked = passes;
    record.end = fault_of(result);
    const int most_passes = passes + passes_more;
    bool again = true;
    while (record.end == OrthogonalityEnd::all_passes && again) {
        const HarmonicEdges edges =
            harmonic_edges(points, parameters, orthogonal, share_of_tolerance * options.tolerance);
        record.edge_cycles += edges.cycles;
        record.end = edges.end;
        if (record.end != OrthogonalityEnd::all_passes) break;
        PointField next_points = points;
        ParameterField next_parameters = hermite_map(edges.functions, orthogonal);
        const SolveResult next = solve(next_points, next_parameters, options);
        SolveResult both = continued(result, next);
        record.end = fault_of(next);
        if (record.end != OrthogonalityEnd::all_passes) {
            result.cycles = both.cycles;
            result.history = std::move(both.history);
            result.safeguards = std::move(both.safeguards);
            break;
        }
        result = std::move(both);
        points = std::move(next_points);
        parameters = std::move(next_parameters);
        ++record.passes;
        record.limited = edges.limited;
        again = record.passes < passes || (edges.limited > 0 && record.passes < most_passes);
    }
    result.orthogonality = record;
}

}  // namespace hexweave
