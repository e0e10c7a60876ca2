// SPDX-License-Identifier: Apache-2.0
// How many cells of a grid are folded: what a solve started from and what it came to.
#pragma once

#include "core/field.h"

namespace hexweave {

/// Cells with a corner that is not positive. Of a block: the triple product of the corner's three
/// edges (right-handed blocks are positive). Of a planar face (all z equal): the corner's signed
/// area, against the sign of the face's whole area, so that either sense may be used. Of a face in
/// space: the corner's normal against the cell's mean normal.
long count_folded(const PointField& points);

}  // namespace hexweave
