// SPDX-License-Identifier: Apache-2.0
// The hierarchy of grids of one face or block, and the nonlinear multigrid cycle (full
// approximation scheme) of the Poisson grid system on it.
#pragma once

#include <vector>

#include "core/field.h"
#include "elliptic/assembly.h"
#include "elliptic/elliptic_solver.h"
#include "elliptic/level.h"

namespace hexweave {

/// How a cycle is made.
struct CycleOptions {
    int sweeps_before = 0;  ///< of relaxation, before a level turns to the coarser one
    int sweeps_after = 3;
    double relaxation = 1;  ///< factor of every correction
    int least_nodes = 9;    ///< along a coarsened axis of the coarsest grid

    /// What was found best for faces (axes = 2) and blocks (axes = 3).
    static CycleOptions of(int axes);
};

class Multigrid {
public:
    /// `points`: the boundary, and the start grid inside. The parameters are taken over, and may be
    /// asked back.
    Multigrid(const PointField& points, ParameterField&& parameters, const CycleOptions& options);

    /// Nested iteration: solves the coarsest grid, then goes up to the finest with a cycle on every
    /// level between. What is carried up are the changes of the start grid, not the points.
    void start();
    /// One cycle on the finest grid; the largest displacement it brought, in cells.
    double cycle();

    /// Interior nodes only: boundary nodes of `points` are not touched.
    void write(PointField& points) const;
    ParameterField parameters() const;

private:
    void smooth(std::size_t index, RightHandSide side, int sweeps);
    void descend_and_return(std::size_t index, RightHandSide side);
    void solve_coarsest(RightHandSide side, int steps);

    CycleOptions options_;
    std::vector<Level> levels_;  ///< the finest first
    double weight_scale_ = 1;
    bool precise_ = false;
};

}  // namespace hexweave
