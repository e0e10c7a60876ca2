// SPDX-License-Identifier: Apache-2.0
// From an elliptic grid to one whose lines meet chosen sides of the face at right angles: harmonic
// edge functions on the grid there is, a Hermite map from them, and the grid system once more.
#pragma once

#include <array>
#include <functional>

#include "core/field.h"
#include "elliptic/elliptic_solver.h"
#include "faces/hermite_map.h"

namespace hexweave {

/// New edge functions on the sides marked in `orthogonal`: the boundary values of harmonic s and t
/// without flux across those sides, solved on the grid `points`, to `tolerance` of the difference
/// between neighbours. `parameters` (s and t of the present grid) are the start, and give the edge
/// functions of the other sides. No interval of a marked side shrinks to less than a fifth, so that
/// all functions increase. [Spekreijse & Boerstoel 1996, section 2.4, eq. (46)]
struct HarmonicEdges {
    EdgeFunctions functions;
    OrthogonalityEnd end = OrthogonalityEnd::all_passes;  ///< why they cannot be used, where not
    int limited = 0;  ///< intervals of edges that were kept from vanishing
    int cycles = 0;   ///< of multigrid
};
HarmonicEdges harmonic_edges(const PointField& points, const ParameterField& parameters,
                             const std::array<bool, 4>& orthogonal, double tolerance);

/// What solves for the grid of a face: solve_elliptic, or the like.
using FaceSolver =
    std::function<SolveResult(PointField&, const ParameterField&, const EllipticOptions&)>;

/// How often the edge functions are to be found anew: twice, as the first come from a grid that is
/// far from orthogonal; once where two sides meet flat and one of them is marked, because exact
/// orthogonality there makes the first cell along the side twice as wide as the second.
int orthogonal_passes(const std::array<bool, 4>& orthogonal,
                      const std::array<bool, 4>& flat_corners);

/// Replaces a converged grid without folded cells, the solution for `parameters`, by an orthogonal
/// one: in `passes` passes, or a few more while the grid slants too much for its edge functions. A
/// pass whose grid does not converge or has folded cells is undone, and the grid before it is the
/// result. `result` is continued: cycles and history of all passes, the rest of the last one kept;
/// its `orthogonality` says how far it got.
void make_orthogonal(PointField& points, ParameterField parameters,
                     const std::array<bool, 4>& orthogonal, int passes,
                     const EllipticOptions& options, SolveResult& result,
                     const FaceSolver& solve = solve_elliptic);

}  // namespace hexweave
