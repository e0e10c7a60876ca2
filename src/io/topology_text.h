// SPDX-License-Identifier: Apache-2.0
// What a resolved topology holds, as `check` prints it.
#pragma once

#include <string>

#include "topology/topology.h"

namespace hexweave {

/// A line per edge whose cells are not as written; empty where there is none.
std::string adjusted_counts_text(const Topology& topology);

/// Counts, a line per zone with its cells, a line per boundary, and the memory that a run needs.
std::string to_text(const Topology& topology);

}  // namespace hexweave
