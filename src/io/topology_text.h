// SPDX-License-Identifier: Apache-2.0
// What a resolved topology holds, as `check` prints it.
#pragma once

#include <string>

#include "topology/topology.h"

namespace hexweave {

/// A line per edge whose cells are more than asked for; empty where there is none.
std::string adjusted_counts_text(const Topology& topology);

/// "translation [0, 0.85, 0]", "rotation about x by 0.17 through [0, 0]".
std::string map_text(const Periodicity& periodicity);

/// How the grid is swept and mirrored, a line each; empty where it is not.
std::string copies_text(const Topology& topology);

/// Counts, a line per zone with its cells, per interface and per boundary, and the memory that a
/// run needs, which holds `solved`: the topology itself, or that of the finest level of a nested
/// family.
std::string to_text(const Topology& topology, const Topology& solved);

}  // namespace hexweave
