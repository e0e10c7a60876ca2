// SPDX-License-Identifier: Apache-2.0
// When two edges have the same distribution, told by their laws.
#pragma once

#include "topology/topology.h"

namespace hexweave {

/// The law of an edge run through backwards. Not for formulas and SameAs, which it returns as they
/// are.
SpacingLaw turned(const SpacingLaw& law, bool reversed);

/// Whether two laws give edges of equally many cells the same normalized distribution as far as
/// their values tell: equal values, and equal lengths (to 1e-9) where sizes are absolute. Formulas
/// cannot be compared and count as different.
bool same_distribution(const SpacingLaw& a, double length_a, const SpacingLaw& b, double length_b);

}  // namespace hexweave
