// SPDX-License-Identifier: Apache-2.0
// Does a spacing law fit its edge? Asked before any point is made.
#pragma once

#include <string>

#include "topology/topology.h"

namespace hexweave {

/// Why `law` cannot be met with this many cells on an edge of this length, in words ("the first
/// cell, 5, is longer than the edge, 2"), or nothing when it fits: what fits is met to rounding.
/// The spacing of another edge always fits. Precondition: cells >= 1, length > 0.
std::string spacing_misfit(const SpacingLaw& law, int cells, double length);

/// What would fit instead.
std::string spacing_hint(const SpacingLaw& law, int cells, double length);

}  // namespace hexweave
