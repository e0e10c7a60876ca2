// SPDX-License-Identifier: Apache-2.0
// Anderson acceleration: the next grid from the last few Picard steps instead of the last one
// alone.
#pragma once

#include <cstddef>
#include <vector>

#include "elliptic/node_lattice.h"

namespace hexweave {

/// Anderson acceleration of x <- x + f(x) in its least-squares form [Walker & Ni 2011], with
/// residuals f weighed in cells of the present grid.
class Acceleration {
public:
    /// `window`: how many past steps are used, at least one.
    Acceleration(const NodeLattice& lattice, std::size_t window);

    /// Forgets the past: the next step is a plain one.
    void restart();
    /// Turns `step`, the Picard step f at `points`, into the step to take from there:
    /// damping f - sum g_n (dx_n + damping df_n), with the g that make |f - sum g_n df_n| smallest.
    /// The caller takes it as it is, or restarts.
    void accelerate(const Nodes& points, double damping, Nodes& step);

private:
    void remember(const Nodes& residual);
    std::vector<double> best_combination(const Nodes& points, const Nodes& residual) const;

    NodeLattice lattice_;
    std::size_t window_;
    /// Changes of x and of f, the newest last.
    std::vector<Nodes> point_changes_;
    std::vector<Nodes> residual_changes_;
    Nodes last_residual_;
    Nodes last_step_;
    bool has_last_ = false;
};

}  // namespace hexweave
