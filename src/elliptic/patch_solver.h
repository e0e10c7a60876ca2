// SPDX-License-Identifier: Apache-2.0
// The linear systems of a patch: conjugate gradients, preconditioned by block tridiagonal systems
// along the lines of nodes across its thin cells.
#pragma once

#include <vector>

#include "elliptic/foldover_functional.h"
#include "elliptic/untangle_patch.h"

namespace hexweave {

class PatchSolver {
public:
    explicit PatchSolver(const Patch& patch);

    /// Solves matrix * step = -gradient until the residual has fallen by `reduction` in the
    /// preconditioner's norm, or `most_iterations` are done. Returns the iterations. The step is
    /// one of descent however early the iteration stops.
    int solve(const QuadraticModel& model, double reduction, int most_iterations,
              std::vector<Vec3>& step);

private:
    void factorize(const QuadraticModel& model);
    void precondition(const QuadraticModel& model, const std::vector<Vec3>& from,
                      std::vector<Vec3>& to) const;
    void multiply(const QuadraticModel& model, const std::vector<Vec3>& from,
                  std::vector<Vec3>& to) const;
    double product(const std::vector<Vec3>& a, const std::vector<Vec3>& b) const;

    const Patch& patch_;
    std::vector<std::size_t> line_heads_;
    std::vector<Matrix3> pivots_;  ///< inverse diagonal blocks of the lines' factors
    std::vector<Vec3> residual_;
    std::vector<Vec3> preconditioned_;
    std::vector<Vec3> direction_;
    std::vector<Vec3> image_;
};

}  // namespace hexweave
