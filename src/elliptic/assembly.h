// SPDX-License-Identifier: Apache-2.0
// The Poisson grid system on one level: its coefficients at the present points, and its residual.
#pragma once

#include "elliptic/level.h"

namespace hexweave {

/// What the residual is taken against.
enum class RightHandSide {
    zero,   ///< the finest level
    given,  ///< level.right_hand_sides
    /// level.residuals holds the integrated residual that came down from the finer level;
    /// level.right_hand_sides is made so that this is the residual of the present points.
    from_residual,
};

/// What is wanted: a level that turns to the coarser one at once needs no stencils.
enum class Assembly { residuals, residuals_and_stencils };

struct AssemblyOptions {
    Assembly wanted = Assembly::residuals_and_stencils;
    RightHandSide side = RightHandSide::zero;
    /// Arithmetic in double precision, for residuals below about 1e-5 of a cell.
    bool precise = true;
};

/// Sets weights, residuals (right hand side - operator(points), row scaled) and, where
/// wanted, stencils of the interior nodes. The coefficients alpha^ij come from the points by
/// central differences [Spekreijse & Boerstoel 1996, eqs. (42), (87)], the first-order ones as
/// -T^-1 (alpha^ij s_ij) with the very differences that act on the points: the control functions
/// (19), (83) are never formed, and points that are linear in the parameters solve the equations
/// exactly. Differences and residuals are in double precision. `scale`: a constant for the weights.
void assemble(Level& level, const AssemblyOptions& options, double scale);

}  // namespace hexweave
