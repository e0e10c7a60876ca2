// SPDX-License-Identifier: Apache-2.0
// A start grid folded on purpose: the solution of the elliptic system must not depend on it.
#pragma once

#include "core/field.h"

namespace hexweave {

/// Moves every interior node of a face or block to the place of another, up to half the grid away,
/// by a strong wave that folds the grid over itself many times. Boundary nodes stay; all points
/// stay within the surface that the grid had. Deterministic.
void fold_interior(PointField& points);

}  // namespace hexweave
