// SPDX-License-Identifier: Apache-2.0
// Spacing laws: an edge's own, that of the edge it is said to be like, or that of the nearest
// parallel edge.
#pragma once

#include "core/diagnostics.h"
#include "topology/draft.h"
#include "topology/parallel_edges.h"

namespace hexweave {

/// Sets the law and the asked sizes of every edge. After it a SameAs names an edge whose own law is
/// none, so one step leads to the law. Reports laws that contradict each other, that go round in a
/// circle, or that do not fit their edge.
void resolve_spacing(Network& network, const ParallelEdges& parallels, Diagnostics& diagnostics);

}  // namespace hexweave
