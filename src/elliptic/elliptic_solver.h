// SPDX-License-Identifier: Apache-2.0
// The Poisson grid system of the composite mapping, for faces (nk = 1; planar or minimal surface)
// and blocks alike: one operator, one solver.
#pragma once

#include "core/field.h"
#include "elliptic/solve_result.h"

namespace hexweave {

struct EllipticOptions {
    double tolerance = 1e-3;  ///< estimated remaining displacement, in cells
    int maximum_cycles = 200;
};

/// The algebraic map C -> P: the parameters (s, t, u) of every node; for a face u is unused.
struct ParameterField {
    Field s;
    Field t;
    Field u;
};

/// Solves the Poisson system (24) of a face or (86) of a block with control functions (19), (83)
/// taken from `parameters` by the same central differences as x.  [Spekreijse & Boerstoel 1996]
/// points: boundary nodes are Dirichlet data and kept to the bit; the interior is the start grid,
/// folded or not, and is replaced by the solution (the best of all iterates where it did not
/// converge). Convergence is measured as displacement along the contravariant base vectors (cell
/// units). Deterministic; never throws for hard geometry.
SolveResult solve_elliptic(PointField& points, ParameterField parameters,
                           const EllipticOptions& options);

}  // namespace hexweave
