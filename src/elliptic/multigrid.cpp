// SPDX-License-Identifier: Apache-2.0
#include "elliptic/multigrid.h"

#include <algorithm>
#include <utility>

#include "elliptic/coarsening.h"
#include "elliptic/displacement.h"
#include "elliptic/line_relaxation.h"
#include "elliptic/transfer.h"

namespace hexweave {

namespace {

/// Relaxations of the coarsest grid within a cycle, of a sweep each: when it is one of several,
/// and when it is the only one.
constexpr int coarsest_steps = 4;
constexpr int lone_steps = 12;

/// The coarsest grid is solved so far before its changes are carried up, in cells, or so often
/// relaxed.
constexpr double coarsest_displacement = 1e-3;
constexpr int coarsest_trials = 100;

/// Sweeps over a level that has just been given the changes of the one below.
constexpr int first_sweeps = 1;

/// Where displacements are larger than this, residuals in single precision do.
constexpr double least_imprecise = 3e-4;

bool is_planar(const PointField& points) {
    if (points.extent().nk > 1) return false;
    const double* const z = points.z.data();
    return std::all_of(z, z + points.extent().nodes(), [&](double v) { return v == z[0]; });
}

/// Makes weights of order one, whatever the unit of length.
double inverse_scale(const PointField& points) {
    double size = 0;
    for (const Field* field : {&points.x, &points.y, &points.z}) {
        const auto [low, high] =
            std::minmax_element(field->data(), field->data() + points.extent().nodes());
        size = std::max(size, *high - *low);
    }
    if (!(size > 0)) return 1;
    const double square = 1 / (size * size);
    return points.extent().nk > 1 ? square * square : square;
}

/// Each parameter is freed once it is stored: at its peak a solve holds them once.
Level finest_level(const PointField& points, ParameterField&& parameters) {
    Level level;
    level.extent = points.extent();
    level.shape = RowShape(level.extent.ni);
    level.axes = level.extent.nk > 1 ? 3 : 2;
    level.components = is_planar(points) ? 2 : 3;
    level.points = RowArray<double>(level.extent, level.components);
    level.parameters = RowArray<double>(level.extent, level.axes);
    store(points.x, 0, level.points);
    store(points.y, 1, level.points);
    if (level.components == 3) store(points.z, 2, level.points);
    store(std::exchange(parameters.s, {}), 0, level.parameters);
    store(std::exchange(parameters.t, {}), 1, level.parameters);
    if (level.axes == 3) store(std::exchange(parameters.u, {}), 2, level.parameters);
    return level;
}

void allocate_work(Level& level, bool is_finest) {
    level.stencils = RowArray<float>(
        level.extent, level.axes == 3 ? StencilLayout<3>::size : StencilLayout<2>::size);
    level.weights = RowArray<float>(level.extent, 1);
    level.residuals = RowArray<float>(level.extent, level.components);
    level.corrections = RowArray<float>(level.extent, level.components);
    if (is_finest) {
        level.steps = RowArray<float>(level.extent, level.components);
    } else {
        level.right_hand_sides = RowArray<double>(level.extent, level.components);
    }
}

}  // namespace

CycleOptions CycleOptions::of(int axes) {
    return axes == 3 ? CycleOptions{0, 3, 1, 9} : CycleOptions{2, 2, 1, 33};
}

Multigrid::Multigrid(const PointField& points, ParameterField&& parameters,
                     const CycleOptions& options)
    : options_(options), weight_scale_(inverse_scale(points)) {
    levels_.push_back(finest_level(points, std::move(parameters)));
    for (const auto& halved : plan_coarsening(levels_.front(), options.least_nodes)) {
        levels_.push_back(coarser_level(levels_.back(), halved));
    }
    for (Level& level : levels_) allocate_work(level, &level == &levels_.front());
}

void Multigrid::write(PointField& points) const {
    const Level& finest = levels_.front();
    restore_interior(finest.points, 0, points.x);
    restore_interior(finest.points, 1, points.y);
    if (finest.components == 3) restore_interior(finest.points, 2, points.z);
}

ParameterField Multigrid::parameters() const {
    const Level& finest = levels_.front();
    ParameterField parameters{Field(finest.extent), Field(finest.extent), {}};
    restore(finest.parameters, 0, parameters.s);
    restore(finest.parameters, 1, parameters.t);
    if (finest.axes == 3) {
        parameters.u = Field(finest.extent);
        restore(finest.parameters, 2, parameters.u);
    }
    return parameters;
}

/// Relaxes with coefficients frozen at the present points.
void Multigrid::smooth(std::size_t index, RightHandSide side, int sweeps) {
    Level& level = levels_[index];
    assemble(level, {Assembly::residuals_and_stencils, side, precise_}, weight_scale_);
    level.corrections.clear();
    relax_lines(level, sweeps);
    add_corrections(level, options_.relaxation);
}

void Multigrid::solve_coarsest(RightHandSide side, int steps) {
    for (int step = 0; step < steps; ++step) {
        smooth(levels_.size() - 1, side, 1);
        if (side == RightHandSide::from_residual) side = RightHandSide::given;
    }
}

void Multigrid::descend_and_return(std::size_t index, RightHandSide side) {
    if (index + 1 == levels_.size()) {
        solve_coarsest(side, levels_.size() == 1 ? lone_steps : coarsest_steps);
        return;
    }
    Level& level = levels_[index];
    Level& coarse = levels_[index + 1];
    if (options_.sweeps_before > 0) {
        smooth(index, side, options_.sweeps_before);
        if (side == RightHandSide::from_residual) side = RightHandSide::given;
    }
    // The residual that is left is that of the nonlinear equations, not of the frozen ones: where
    // the grid is strongly bent this saves half of the cycles.
    assemble(level, {Assembly::residuals, side, precise_}, weight_scale_);
    if (side == RightHandSide::from_residual) side = RightHandSide::given;
    integrate_residuals(level);
    restrict_residuals(level, coarse);
    inject_points(level, coarse);
    descend_and_return(index + 1, RightHandSide::from_residual);
    interpolate_changes(level, coarse);
    add_corrections(level, options_.relaxation);
    smooth(index, side, options_.sweeps_after);
}

double Multigrid::cycle() {
    Level& finest = levels_.front();
    finest.steps.clear();
    descend_and_return(0, RightHandSide::zero);
    const double displacement = largest_displacement(finest, finest.steps);
    precise_ = !(displacement > least_imprecise);
    return displacement;
}

void Multigrid::start() {
    const std::size_t last = levels_.size() - 1;
    if (last == 0) return;
    for (std::size_t n = 0; n < last; ++n) inject_points(levels_[n], levels_[n + 1]);
    for (int trial = 0; trial < coarsest_trials; ++trial) {
        solve_coarsest(RightHandSide::zero, 2);
        const Level& coarsest = levels_[last];
        if (largest_displacement(coarsest, coarsest.corrections) < coarsest_displacement) break;
    }
    for (std::size_t n = last; n-- > 0;) {
        interpolate_changes(levels_[n], levels_[n + 1]);
        add_corrections(levels_[n], 1);
        smooth(n, RightHandSide::zero, first_sweeps);
        if (n > 0) descend_and_return(n, RightHandSide::zero);
    }
}

}  // namespace hexweave
