// SPDX-License-Identifier: Apache-2.0
// Cell counts: opposite sides of a face have equally many cells, so one mention fixes a whole chain
// of edges.
#pragma once

#include "core/diagnostics.h"
#include "topology/draft.h"
#include "topology/parallel_edges.h"

namespace hexweave {

/// Sets the cells of every edge, face and block. An edge whose count is unknown or in conflict (an
/// error tells) keeps 0 cells, and so does what it bounds.
void resolve_counts(Network& network, const ParallelEdges& parallels, Diagnostics& diagnostics);

}  // namespace hexweave
