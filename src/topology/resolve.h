// SPDX-License-Identifier: Apache-2.0
// Stage 2: a Case into a Topology: names, directions, orientations, cell counts, spacing laws.
#pragma once

#include "core/diagnostics.h"
#include "topology/case.h"
#include "topology/topology.h"

namespace hexweave {

/// Resolves everything that the case leaves to be inferred. All faults go to `diagnostics`,
/// together with what reading found; throws InputError when there are errors (of either stage).
Topology resolve(const Case& c, Diagnostics& diagnostics);

}  // namespace hexweave
