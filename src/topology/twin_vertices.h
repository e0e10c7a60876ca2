// SPDX-License-Identifier: Apache-2.0
// Vertices that lie in one place under two names: what meets there is not joined.
#pragma once

#include "core/diagnostics.h"
#include "topology/topology.h"

namespace hexweave {

/// Warns of every two vertices that are no farther apart than 1e-9 of the size of the whole.
void warn_of_twin_vertices(const Topology& topology, Diagnostics& diagnostics);

}  // namespace hexweave
