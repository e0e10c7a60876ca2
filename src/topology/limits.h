// SPDX-License-Identifier: Apache-2.0
// How large the grid is: in space, in nodes, in memory.
#pragma once

#include <cstddef>
#include <string>

#include "core/diagnostics.h"
#include "topology/topology.h"

namespace hexweave {

/// "95 kB", "5.1 GB".
std::string memory_text(double bytes);

/// Fills `size` and `planar` from the vertices and sampled edges. `three_dimensional`: the case has
/// blocks.
void measure_extent(Topology& topology, bool three_dimensional);

/// Reports zones with more nodes than 32-bit CGNS sizes can count (each axis and the product), at
/// their place. False when there are any.
bool check_zone_sizes(const Topology& topology, Diagnostics& diagnostics);

/// Bytes that a run needs at its peak: the points of the whole grid, held and written, and the
/// solver's workspace of the largest zones, as many at once as there are threads. A figure to stop
/// a hopeless run by, not a measurement: right to about a third.
double estimated_bytes(const Topology& topology, int threads);
/// The same of one zone.
double estimated_bytes(double nodes);

/// Reports, at the largest zone, a grid that needs more than `available` bytes.
void check_memory(const Topology& topology, int threads, std::size_t available,
                  Diagnostics& diagnostics);

}  // namespace hexweave
