// SPDX-License-Identifier: Apache-2.0
// The regularised functional whose minimum has no folded cell: at every corner, with J the map from
// the target corner to the actual one (d = 2 or 3 dimensions),
//     f = |J|^2 / chi^(2/d) + (det^2 + 1) / (2 chi),  chi = (det + sqrt(epsilon^2 + det^2)) / 2.
// It is finite for folded cells, and as epsilon goes to zero they cost more than any other.
// [Garanzha, Kaporin, Kudryavtseva, Protais, Ray & Sokolov 2021, with lambda = 1/2]
#pragma once

#include <array>
#include <vector>

#include "core/vec3.h"
#include "elliptic/untangle_patch.h"

namespace hexweave {

/// Row by row.
using Matrix3 = std::array<double, 9>;

/// The free nodes' quadratic model of the functional: gradient, and a matrix that is never
/// indefinite. It couples a free node to those ahead of it (`ahead` of the patch); those behind
/// hold the transposed blocks.
struct QuadraticModel {
    std::vector<Vec3> gradient;
    std::vector<Matrix3> diagonal;
    std::vector<Matrix3> coupling;  ///< couplings() a node, towards the nodes ahead
};

struct FunctionalValue {
    double energy = 0;
    double least_determinant = 0;  ///< over all corners; 1 is the target's
};

/// chi of a determinant.
double regularised(double determinant, double epsilon);

FunctionalValue evaluate(const Patch& patch, double epsilon);

/// Newton's matrix but for the curvature of the determinant itself, the part in the span of J and
/// its cofactors made positive.
void assemble(const Patch& patch, double epsilon, QuadraticModel& model);

}  // namespace hexweave
