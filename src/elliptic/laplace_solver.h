// SPDX-License-Identifier: Apache-2.0
// Harmonic fields on the grid of a face, by multigrid: what the edge functions of a grid that is
// orthogonal at its boundary are taken from.
#pragma once

#include <array>
#include <vector>

#include "elliptic/conductances.h"

namespace hexweave {

struct LaplaceOptions {
    double tolerance = 1e-6;  ///< last change of a value, over its differences to its neighbours
    int maximum_cycles = 50;
};

struct LaplaceResult {
    bool converged = false;
    int cycles = 0;
    double change = 0;  ///< of the last cycle, over the differences to the neighbours
};

/// The networks of one face from its own nodes down to three by three, each of half the cells of
/// the one before. One hierarchy serves every combination of boundary conditions.
class LaplaceHierarchy {
public:
    /// The face must have no folded cell, and at least one cell each way.
    explicit LaplaceHierarchy(const PointField& points);
    /// Of another network than laplace_conductances.
    explicit LaplaceHierarchy(Conductances finest);

    const std::vector<Conductances>& networks() const { return networks_; }
    const std::vector<std::array<AxisCoarsening, 2>>& coarsenings() const { return coarsenings_; }

private:
    std::vector<Conductances> networks_;
    std::vector<std::array<AxisCoarsening, 2>> coarsenings_;  ///< from a network to the next
};

/// Makes `values` (extent of the face) harmonic, by conjugate gradients with V-cycles as the
/// preconditioner, lines relaxed in both directions. On the sides marked in `fixed` (imin, imax,
/// jmin, jmax) the values are given and stay; across the others there is no flux. The rest of
/// `values` is the start. At least one pair of opposite sides must be fixed.
LaplaceResult solve_laplace(const LaplaceHierarchy& hierarchy, const std::array<bool, 4>& fixed,
                            const LaplaceOptions& options, Field& values);

}  // namespace hexweave
