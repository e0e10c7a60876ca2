// SPDX-License-Identifier: Apache-2.0
// Where a map from the nodes of a face onto the unit square takes a given value.
#pragma once

#include <array>

#include "core/field.h"
#include "core/vec3.h"
#include "faces/straight_line_map.h"

namespace hexweave {

/// A place between the nodes of a face: in cell (i, j), at shares alpha and beta of its way along i
/// and j, 0 to 1.
struct CellPlace {
    int i = 0;
    int j = 0;
    double alpha = 0.5;
    double beta = 0.5;

    /// The field there: p and the next nodes blended bilinearly.
    double of(const Field& values) const;
};

/// The place where the fields (s, t), bilinear in every cell, have the value `wanted`. They map the
/// boundary onto that of the unit square and have no folded cells, or few. The search walks from
/// cell to cell from `start`; where it goes round in circles all cells are looked at, and the place
/// nearest to being right is taken.
/// [Spekreijse & Boerstoel 1996, section 4.2, step 5]
CellPlace place_of(const Field& s, const Field& t, const SquarePoint& wanted,
                   const CellPlace& start);

}  // namespace hexweave
