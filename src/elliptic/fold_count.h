// SPDX-License-Identifier: Apache-2.0
// The fold check: which cells of a grid are folded, fast enough to run over every grid. The rule is
// that of the report (a cell with a corner whose scaled Jacobian is not above 1e-9); the report's
// own evaluation shares no code with it.
#pragma once

#include <vector>

#include "core/field.h"
#include "core/orientation.h"

namespace hexweave {

/// The scaled Jacobian that a corner must exceed.
inline constexpr double fold_limit = 1e-9;

/// Whether a corner is sound: its Jacobian determinant against the product of its legs' squared
/// lengths; without a square root.
constexpr bool is_sound_corner(double determinant, double squared_lengths) {
    return determinant > 0 && determinant * determinant > fold_limit * fold_limit * squared_lengths;
}

struct FoldedCell {
    Node cell{};
    /// Boundary nodes alone fold it: no interior node can cure it.
    bool by_boundary = false;
};

/// The normal that corners of a planar face are measured against: that of the plane, to the side on
/// which the face's boundary encloses a positive area, so that a face of either sense is sound.
/// Zero when the face is not planar: when points are off it by more than `thickness` times the root
/// of twice that area.
Vec3 plane_normal(const PointField& face, double thickness = 1e-12);

/// Cells with a corner whose scaled Jacobian is not above `fold_limit`. Of a block: the triple
/// product of the corner's three edges over the product of their lengths (right-handed blocks are
/// positive). Of a face: the corner's normal against plane_normal, or, of a face in space, against
/// the cell's mean normal. A corner that is flat (no more than `fold_limit` either way) where two
/// sides of the grid meet at more than 150 degrees does not fold its cell; nor does one at a pole,
/// where neighbours on the boundary are one point. The layers of cells are
/// checked in parallel.
long count_folded(const PointField& points);

/// The same cells one by one, i fastest.
std::vector<FoldedCell> folded_cells(const PointField& points);

/// Those of `cells` that are (still) folded.
std::vector<FoldedCell> still_folded(const PointField& points,
                                     const std::vector<FoldedCell>& cells);

}  // namespace hexweave
