// SPDX-License-Identifier: Apache-2.0
#include "elliptic/picard_iteration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "elliptic/acceleration.h"
#include "elliptic/cell_units.h"
#include "elliptic/convergence.h"
#include "elliptic/grid_operator.h"
#include "elliptic/linear_solver.h"

namespace hexweave {

namespace {

constexpr std::size_t acceleration_window = 5;

/// Tighter linear solves do not save Picard steps, looser ones spoil the acceleration.
constexpr LinearOptions linear_options{3e-2, 100};

/// After so many steps without a smaller displacement than ever before, steps are shortened.
constexpr int patience = 15;
constexpr double shortening = 0.6;
constexpr double least_damping = 0.2;

constexpr double damping_of_plain_steps = 0.5;

Nodes to_nodes(const PointField& points) {
    Nodes nodes(points.extent().nodes());
    for (std::size_t p = 0; p < nodes.size(); ++p) nodes[p] = points[p];
    return nodes;
}

Nodes to_nodes(const ParameterField& parameters, int axes) {
    Nodes nodes(parameters.s.extent().nodes());
    for (std::size_t p = 0; p < nodes.size(); ++p) {
        nodes[p] = {parameters.s[p], parameters.t[p], axes == 3 ? parameters.u[p] : 0};
    }
    return nodes;
}

class PicardIteration {
public:
    PicardIteration(const PointField& points, const ParameterField& parameters, Safeguard kind,
                    BestIterate& best)
        : accelerated_(kind == Safeguard::anderson_picard),
          damping_(accelerated_ ? 1 : damping_of_plain_steps),
          lattice_(points.extent()),
          points_(to_nodes(points)),
          parameters_(to_nodes(parameters, lattice_.axes)),
          best_(best),
          residual_(points_.size()),
          step_(points_.size()),
          linear_(lattice_),
          acceleration_(lattice_, acceleration_window) {}

    /// Iterates and fills in the result but for the counts of folded cells.
    void run(const EllipticOptions& options, SolveResult& result);

    /// Writes the interior nodes back.
    void write(PointField& points) const {
        for_interior(lattice_, [&](std::size_t p) { points.set(p, points_[p]); });
    }

private:
    double picard_step();
    void judge(double displacement, int cycle);
    double take_step();
    bool retreat();
    bool is_known(double displacement) const;

    bool accelerated_;
    double damping_;
    NodeLattice lattice_;
    Nodes points_;
    Nodes parameters_;
    BestIterate& best_;
    Nodes residual_;
    Nodes step_;
    Stencils stencils_;
    LinearSolver linear_;
    Acceleration acceleration_;
    bool step_is_solved_ = false;  ///< the linear solver got as far as it was asked
    double least_displacement_ = std::numeric_limits<double>::infinity();
    int since_least_ = 0;
};

/// Sets step_ to the displacement that solves the equations frozen at points_; its size in cells.
double PicardIteration::picard_step() {
    assemble_stencils(lattice_, points_, parameters_, stencils_);
    apply_stencils(lattice_, stencils_, points_, residual_);
    step_is_solved_ = linear_.solve(stencils_, residual_, linear_options, step_);
    return largest_displacement(lattice_, points_, step_);
}

/// Offers the grid, and shortens the steps when displacements did not fall for long. From a folded
/// start they rise before they fall, so a single rise means nothing.
void PicardIteration::judge(double displacement, int cycle) {
    PointField grid = best_.points;
    write(grid);
    best_.offer(grid, displacement, cycle);
    if (displacement < least_displacement_) {
        least_displacement_ = displacement;
        since_least_ = 0;
    } else if (++since_least_ % patience == 0) {
        damping_ = std::max(shortening * damping_, least_damping);
        acceleration_.restart();
    }
}

/// The size in cells of the step taken.
double PicardIteration::take_step() {
    if (accelerated_) {
        acceleration_.accelerate(points_, damping_, step_);
    } else {
        for_interior(lattice_, [&](std::size_t p) { step_[p] = damping_ * step_[p]; });
    }
    const double size = largest_displacement(lattice_, points_, step_);
    for_interior(lattice_, [&](std::size_t p) { points_[p] += step_[p]; });
    return size;
}

/// Back to the best grid, with shorter steps from there; false when that was tried before.
bool PicardIteration::retreat() {
    points_ = to_nodes(best_.points);
    damping_ *= shortening;
    acceleration_.restart();
    return damping_ >= least_damping;
}

/// Whether the linear solver got far enough for the displacement to mean something. What is mere
/// rounding it cannot solve for, and need not.
bool PicardIteration::is_known(double displacement) const {
    return step_is_solved_ || displacement <= rounding_in_cells(lattice_, points_);
}

void PicardIteration::run(const EllipticOptions& options, SolveResult& result) {
    std::vector<double> steps;
    for (int n = 0; n < options.maximum_cycles; ++n) {
        const double displacement = picard_step();
        const int cycle = n > 0 ? result.cycles : best_.cycle;  // the one that gave this grid
        ++result.cycles;
        result.history.push_back(displacement);
        if (!std::isfinite(displacement)) {
            steps.clear();
            if (retreat()) continue;
            result.status = SolveStatus::diverged;
            return;
        }
        judge(displacement, cycle);
        steps.push_back(std::max(displacement, take_step()));
        result.displacement = steps.back();
        if (has_converged(steps, options.tolerance) && is_known(displacement)) {
            result.status = SolveStatus::converged;
            return;
        }
    }
    result.status = SolveStatus::not_converged;
    points_ = to_nodes(best_.points);
}

}  // namespace

void iterate_picard(PointField& points, const ParameterField& parameters,
                    const EllipticOptions& options, Safeguard kind, SolveResult& result,
                    BestIterate& best) {
    PicardIteration iteration(points, parameters, kind, best);
    iteration.run(options, result);
    iteration.write(points);
}

}  // namespace hexweave
