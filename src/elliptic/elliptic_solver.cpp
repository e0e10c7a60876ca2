// SPDX-License-Identifier: Apache-2.0
// Multigrid first; where its displacements do not fall, a chain of safeguards.
#include "elliptic/elliptic_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "elliptic/best_iterate.h"
#include "elliptic/cell_units.h"
#include "elliptic/convergence.h"
#include "elliptic/fold_count.h"
#include "elliptic/multigrid.h"
#include "elliptic/node_lattice.h"
#include "elliptic/picard_iteration.h"

namespace hexweave {

namespace {

/// After so many cycles without a smaller displacement than ever before, something else is tried.
constexpr int patience = 8;
/// ... and after so many with a rate that would never do.
constexpr int most_cycles = 60;

/// Displacements beyond this many cells never come back.
constexpr double hopeless_displacement = 1e8;

/// Displacements come to rest at so many times the rounding of coordinates: the coefficients are
/// made of differences of these, and errors add up from node to node. Seen: up to 23.
constexpr double rounding_multiple = 50;
/// ... but where that is more than this, in cells, rounding spoils the grid.
constexpr double most_rounding = 1e-3;

/// Cycles with relaxed corrections, on coarse grids that are not very coarse: what the meander of
/// 1.9 radians takes.
CycleOptions damped(CycleOptions options) {
    options.relaxation = 0.4;
    options.least_nodes = std::max(options.least_nodes, 65);
    return options;
}

/// Whether displacements of this size are as small as double precision lets them become.
bool is_rounding(double displacement, const PointField& points) {
    if (!(displacement <= most_rounding)) return false;
    Nodes nodes(points.extent().nodes());
    for (std::size_t p = 0; p < nodes.size(); ++p) nodes[p] = points[p];
    const double rounding = rounding_in_cells(NodeLattice(points.extent()), nodes);
    return displacement <= rounding_multiple * rounding;
}

/// How a number of cycles ended.
enum class Ending {
    converged,
    no_hope,  ///< something else is to be tried
    ran_out,  ///< there were no more cycles to be made
};

/// Cycles until convergence, or until there is no hope of it. The points are changed only where
/// they converged; the parameters are still there only where they did not.
Ending run_cycles(PointField& points, ParameterField& parameters, const CycleOptions& how,
                  const EllipticOptions& options, SolveResult& result) {
    Multigrid multigrid(points, std::move(parameters), how);
    multigrid.start();
    std::vector<double> steps;
    double least = std::numeric_limits<double>::infinity();
    int since_least = 0;
    const int allowed = std::min(options.maximum_cycles, most_cycles);
    while (static_cast<int>(steps.size()) < allowed && since_least < patience) {
        steps.push_back(multigrid.cycle());
        ++result.cycles;
        result.history.push_back(steps.back());
        result.displacement = steps.back();
        if (!(steps.back() < hopeless_displacement)) {
            result.status = SolveStatus::diverged;
            parameters = multigrid.parameters();
            return Ending::no_hope;
        }
        since_least = steps.back() < least ? 0 : since_least + 1;
        least = std::min(least, steps.back());
        result.rate = convergence_rate(steps);
        if (has_converged(steps, options.tolerance)) {
            result.status = SolveStatus::converged;
            multigrid.write(points);
            return Ending::converged;
        }
    }
    const bool ran_out = allowed == options.maximum_cycles && since_least < patience;
    result.status = SolveStatus::not_converged;
    if (!ran_out) {
        PointField last = points;
        multigrid.write(last);
        if (is_rounding(least, last)) {
            result.status = SolveStatus::converged;
            points = std::move(last);
            return Ending::converged;
        }
    }
    parameters = multigrid.parameters();
    return ran_out ? Ending::ran_out : Ending::no_hope;
}

/// Cycles of one kind, none of which gave a grid that may stand.
struct Trial {
    CycleOptions how;
    int cycles = 0;
};

/// Makes the cycles of all trials once more, from `start`, and offers every grid to `best`. Had the
/// best grid been kept as the cycles went, every solve would need a fifth more memory for it.
void look_again(const PointField& start, const ParameterField& parameters,
                const std::vector<Trial>& trials, BestIterate& best) {
    int cycle = 0;
    for (const Trial& trial : trials) {
        if (trial.cycles == 0) continue;
        Multigrid multigrid(start, ParameterField(parameters), trial.how);
        multigrid.start();
        PointField grid = start;
        for (int n = 0; n < trial.cycles; ++n) {
            const double displacement = multigrid.cycle();
            multigrid.write(grid);
            best.offer(grid, displacement, ++cycle);
        }
    }
}

/// Both kinds of Picard steps; `points` is the solution, or the best grid.
void try_picard(PointField& points, const ParameterField& parameters,
                const EllipticOptions& options, SolveResult& result, BestIterate& best) {
    for (const Safeguard kind : {Safeguard::anderson_picard, Safeguard::krylov_picard}) {
        result.safeguards.push_back(kind);
        const std::size_t before = result.history.size();
        iterate_picard(points, parameters, options, kind, result, best);
        const std::vector<double> steps(
            result.history.begin() + static_cast<std::ptrdiff_t>(before), result.history.end());
        result.rate = convergence_rate(steps);
        if (result.status == SolveStatus::converged) return;
    }
}

void solve_inside(PointField& points, ParameterField parameters, const EllipticOptions& options,
                  SolveResult& result) {
    const CycleOptions usual = CycleOptions::of(points.extent().nk > 1 ? 3 : 2);
    std::vector<Trial> trials{{usual}, {damped(usual)}};
    Ending ending = Ending::no_hope;
    for (std::size_t n = 0; n < trials.size() && ending == Ending::no_hope; ++n) {
        if (n > 0) result.safeguards.push_back(Safeguard::damping);
        const int before = result.cycles;
        ending = run_cycles(points, parameters, trials[n].how, options, result);
        trials[n].cycles = result.cycles - before;
    }
    if (ending == Ending::converged) return;
    const PointField start = points;
    BestIterate best(start);
    if (ending == Ending::no_hope) try_picard(points, parameters, options, result, best);
    if (result.status == SolveStatus::converged) return;
    look_again(start, parameters, trials, best);
    points = std::move(best.points);
    result.kept_cycle = best.cycle;
}

}  // namespace

SolveResult solve_elliptic(PointField& points, ParameterField parameters,
                           const EllipticOptions& options) {
    SolveResult result;
    result.tolerance = options.tolerance;
    result.folded_before = count_folded(points);
    if (NodeLattice(points.extent()).has_interior()) {
        solve_inside(points, std::move(parameters), options, result);
    } else {
        result.status = SolveStatus::converged;
    }
    result.folded_after = count_folded(points);
    return result;
}

}  // namespace hexweave
