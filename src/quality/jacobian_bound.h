// SPDX-License-Identifier: Apache-2.0
// Whether a cell is sound everywhere inside, not only at its corners: bounds of the Jacobian of its
// trilinear map.
#pragma once

#include <array>

#include "core/vec3.h"

namespace hexweave {

/// The eight nodes of a cell: corner c lies at the high end of axis a where bit a of c is set.
using CellNodes = std::array<Vec3, 8>;

/// The coefficients, in the Bernstein basis of degree (2, 2, 2), of the Jacobian determinant of the
/// map x(i, j, k) from the unit cube that is linear in each: coefficient (a, b, c) stands at
/// a + 3 b + 9 c. The determinant lies between the least and the greatest of them, is equal to them
/// at the corners (a, b and c each 0 or 2), and its integral, the volume, is their mean.
/// [Johnen, Weill & Remacle 2017, "Robust and efficient validation of the linear hexahedral
/// element"]
using JacobianCoefficients = std::array<double, 27>;
JacobianCoefficients jacobian_coefficients(const CellNodes& nodes);

double cell_volume(const JacobianCoefficients& coefficients);

enum class JacobianVerdict {
    positive,      ///< at every point of the cell, proven
    not_positive,  ///< somewhere, proven
    undecided,     ///< too close to zero for the subdivisions that are tried
};

/// Corner by corner, whether a determinant of zero (to 1e-9 of its edges' product) is to be passed
/// over: flat by declaration.
using FlatCorners = std::array<bool, 8>;

/// Proves the Jacobian positive over the whole cell, or finds a point where it is not, by halving
/// the cell along all axes until the coefficients decide, at most `depth` times.
JacobianVerdict judge_jacobian(const JacobianCoefficients& coefficients, const FlatCorners& flat,
                               int depth = 6);

}  // namespace hexweave
