// SPDX-License-Identifier: Apache-2.0
// Picard iteration [Spekreijse & Boerstoel 1996, eqs. (43)-(45)]: coefficients from the last grid,
// a loose linear solve for the step, Anderson acceleration of the steps.
#include "elliptic/elliptic_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "elliptic/acceleration.h"
#include "elliptic/cell_units.h"
#include "elliptic/fold_count.h"
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

/// The convergence rate is never believed to be better or worse than this; before three steps were
/// taken it is not known.
constexpr double best_rate = 0.1;
constexpr double worst_rate = 0.99;
constexpr double unknown_rate = 0.9;

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

/// What is left to move after the last of `steps` (in cells), were they to go on shrinking as they
/// did: the rest of a geometric series.
double remaining_displacement(const std::vector<double>& steps) {
    const std::size_t n = steps.size();
    if (steps.back() == 0) return 0;
    double rate = unknown_rate;
    if (n >= 3) {
        const double last = steps[n - 1] / steps[n - 2];
        const double mean = std::sqrt(steps[n - 1] / steps[n - 3]);
        rate = std::clamp(std::max(last, mean), best_rate, worst_rate);
    }
    return steps.back() * rate / (1 - rate);
}

class PicardIteration {
public:
    PicardIteration(const PointField& points, const ParameterField& parameters)
        : lattice_(points.extent()),
          points_(to_nodes(points)),
          parameters_(to_nodes(parameters, lattice_.axes)),
          best_(points_),
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
    void judge(double displacement);
    double take_accelerated_step();
    bool retreat();

    NodeLattice lattice_;
    Nodes points_;
    Nodes parameters_;
    Nodes best_;  ///< where the displacement was smallest
    Nodes residual_;
    Nodes step_;
    Stencils stencils_;
    LinearSolver linear_;
    Acceleration acceleration_;
    bool step_is_solved_ = false;  ///< the linear solver got as far as it was asked
    double damping_ = 1;
    double least_displacement_ = std::numeric_limits<double>::infinity();
    int since_best_ = 0;
};

/// Sets step_ to the displacement that solves the equations frozen at points_; its size in cells.
double PicardIteration::picard_step() {
    assemble_stencils(lattice_, points_, parameters_, stencils_);
    apply_stencils(lattice_, stencils_, points_, residual_);
    step_is_solved_ = linear_.solve(stencils_, residual_, linear_options, step_);
    return largest_displacement(lattice_, points_, step_);
}

/// Keeps the best grid, and shortens the steps when there was no better one for long. From a folded
/// start displacements rise before they fall, so a single rise means nothing.
void PicardIteration::judge(double displacement) {
    if (displacement < least_displacement_) {
        least_displacement_ = displacement;
        best_ = points_;
        since_best_ = 0;
    } else if (++since_best_ % patience == 0) {
        damping_ = std::max(shortening * damping_, least_damping);
        acceleration_.restart();
    }
}

/// The size in cells of the step taken.
double PicardIteration::take_accelerated_step() {
    acceleration_.accelerate(points_, damping_, step_);
    const double size = largest_displacement(lattice_, points_, step_);
    for_interior(lattice_, [&](std::size_t p) { points_[p] += step_[p]; });
    return size;
}

/// Back to the best grid, with shorter steps from there; false when that was tried before.
bool PicardIteration::retreat() {
    points_ = best_;
    damping_ *= shortening;
    acceleration_.restart();
    return damping_ >= least_damping;
}

void PicardIteration::run(const EllipticOptions& options, SolveResult& result) {
    std::vector<double> steps;
    while (result.cycles < options.maximum_cycles) {
        const double displacement = picard_step();
        ++result.cycles;
        result.history.push_back(displacement);
        if (!std::isfinite(displacement)) {
            steps.clear();
            if (retreat()) continue;
            result.status = SolveStatus::diverged;
            return;
        }
        judge(displacement);
        steps.push_back(std::max(displacement, take_accelerated_step()));
        result.displacement = steps.back();
        if (step_is_solved_ && steps.back() < options.tolerance &&
            remaining_displacement(steps) < options.tolerance) {
            result.status = SolveStatus::converged;
            return;
        }
    }
    result.status = SolveStatus::not_converged;
    if (since_best_ > 0) points_ = best_;
}

}  // namespace

SolveResult solve_elliptic(PointField& points, const ParameterField& parameters,
                           const EllipticOptions& options) {
    SolveResult result;
    result.tolerance = options.tolerance;
    result.folded_before = count_folded(points);
    if (NodeLattice(points.extent()).has_interior()) {
        PicardIteration iteration(points, parameters);
        iteration.run(options, result);
        iteration.write(points);
    } else {
        result.status = SolveStatus::converged;
    }
    result.folded_after = count_folded(points);
    return result;
}

}  // namespace hexweave
