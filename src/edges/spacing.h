// SPDX-License-Identifier: Apache-2.0
// Spacing laws: where the points of an edge lie, as fractions of its arc length.
#pragma once

#include <vector>

#include "topology/topology.h"

namespace hexweave {

/// The positions that `law` gives to an edge of this length: cells + 1 of them; with a refinement r
/// those of cells * r + 1, of which every r-th is what it gives without, and between which the law
/// is continued (a law of listed positions cannot be). From exactly 0 to exactly 1, strictly
/// increasing; fractions of arc length, or of the curve's parameter for an ExplicitLaw
/// `of_parameter`. Precondition: the law fits (spacing_misfit is empty) and is not SameAs, which
/// needs the other edge's.
std::vector<double> law_fractions(const SpacingLaw& law, int cells, double length,
                                  int refinement = 1);

}  // namespace hexweave
