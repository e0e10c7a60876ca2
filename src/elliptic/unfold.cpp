// SPDX-License-Identifier: Apache-2.0
#include "elliptic/unfold.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "elliptic/foldover_functional.h"
#include "elliptic/patch_solver.h"

namespace hexweave {

namespace {

constexpr double linear_reduction = 0.1;
constexpr double most_linear_iterations = 200;
/// Setting up a step costs as much as so many linear iterations.
constexpr int visits_of_assembly = 10;
constexpr double least_epsilon = 1e-9;
constexpr int halvings = 16;

/// The next epsilon: chi of the least determinant shall fall in proportion as the energy did, by a
/// tenth at least. [Garanzha et al. 2021]
double next_epsilon(double epsilon, double least_determinant, double energy_ratio) {
    const double fall = std::clamp(1 - energy_ratio, 0.1, 1.0);
    const double aim = (1 - fall) * regularised(least_determinant, epsilon);
    if (least_determinant >= aim) return least_epsilon;
    return std::max(least_epsilon, 2 * std::sqrt(aim * (aim - least_determinant)));
}

class Minimization {
public:
    Minimization(Patch& patch, const UnfoldLimits& limits)
        : patch_(patch),
          limits_(limits),
          solver_(patch),
          step_(patch.free.size()),
          epsilon_(limits.epsilon) {}

    Unfolding run();

private:
    bool newton_step();
    bool may_go_on() const {
        return result_.newton_steps < limits_.newton_steps && visits_ < limits_.node_visits;
    }
    void polish();

    Patch& patch_;
    const UnfoldLimits& limits_;
    PatchSolver solver_;
    QuadraticModel model_;
    std::vector<Vec3> step_;
    double epsilon_;
    double energy_ratio_ = 1;  ///< of the last step
    FunctionalValue value_;
    double visits_ = 0;
    Unfolding result_;
};

/// One step down, shortened until the energy falls; false where none was found.
bool Minimization::newton_step() {
    assemble(patch_, epsilon_, model_);
    value_ = evaluate(patch_, epsilon_);
    const double affordable = (limits_.node_visits - visits_) / static_cast<double>(step_.size());
    const int most = static_cast<int>(std::clamp(affordable, 1.0, most_linear_iterations));
    const int iterations = solver_.solve(model_, linear_reduction, most, step_);
    visits_ += (iterations + visits_of_assembly) * static_cast<double>(step_.size());
    result_.linear_iterations += iterations;
    ++result_.newton_steps;
    const std::vector<Vec3> start = patch_.points;
    double length = 1;
    for (int attempt = 0; attempt < halvings; ++attempt, length /= 2) {
        for (std::size_t f = 0; f < step_.size(); ++f) {
            const auto n = static_cast<std::size_t>(patch_.free[f]);
            patch_.points[n] = start[n] + length * step_[f];
        }
        const FunctionalValue next = evaluate(patch_, epsilon_);
        if (next.energy < value_.energy) {
            energy_ratio_ = next.energy / value_.energy;
            value_ = next;
            return true;
        }
    }
    patch_.points = start;
    energy_ratio_ = 1;
    return false;
}

/// From an unfolded patch further down: the barrier keeps it unfolded, and so does this.
void Minimization::polish() {
    epsilon_ = least_epsilon;
    for (int step = 0; step < limits_.steps_after; ++step) {
        const std::vector<Vec3> sound = patch_.points;
        if (!newton_step()) return;
        if (count_folded(patch_) > 0) {
            patch_.points = sound;
            return;
        }
    }
}

Unfolding Minimization::run() {
    result_.folded = count_folded(patch_);
    std::vector<Vec3> best = patch_.points;
    while (result_.folded > 0 && may_go_on()) {
        if (!newton_step() && epsilon_ <= least_epsilon) break;
        const long folded = count_folded(patch_);
        if (folded < result_.folded) {
            result_.folded = folded;
            best = patch_.points;
        }
        epsilon_ = next_epsilon(epsilon_, value_.least_determinant, energy_ratio_);
    }
    if (result_.folded > 0) {
        patch_.points = std::move(best);
    } else {
        polish();
    }
    return result_;
}

}  // namespace

Unfolding unfold(Patch& patch, const UnfoldLimits& limits) {
    return Minimization(patch, limits).run();
}

}  // namespace hexweave
