// SPDX-License-Identifier: Apache-2.0
// Spacing laws: where the points of an edge lie, as fractions of its arc length.
#pragma once

#include <vector>

#include "topology/topology.h"

namespace hexweave {

/// The cells + 1 positions that `law` gives to an edge of this length: from exactly 0 to exactly 1,
/// strictly increasing; fractions of arc length, or of the curve's parameter for an ExplicitLaw
/// `of_parameter`. Precondition: the law fits (spacing_misfit is empty) and is not SameAs, which
/// needs the other edge's.
std::vector<double> law_fractions(const SpacingLaw& law, int cells, double length);

}  // namespace hexweave
