// SPDX-License-Identifier: Apache-2.0
// Cell counts: opposite sides of a face have equally many cells, so one mention fixes a whole chain
// of edges. Counts are then raised as asked: to those of a level, to multiples.
#pragma once

#include <cstdint>
#include <optional>

#include "core/diagnostics.h"
#include "topology/draft.h"
#include "topology/parallel_edges.h"

namespace hexweave {

/// What the counts are raised to, besides what single edges say.
struct CountRules {
    std::optional<Located<int>> multiple_of;
    std::optional<GridFamily> family;  ///< the counts are to be those of its level
};

/// Sets the cells of every edge, face and block. An edge whose count is unknown or in conflict (an
/// error tells) keeps 0 cells, and so does what it bounds. Counts that are not as written are
/// listed in the topology.
void resolve_counts(Network& network, const ParallelEdges& parallels, const CountRules& rules,
                    Diagnostics& diagnostics);

/// The layers of a sweep, raised like the cells of edges.
struct LayerCount {
    std::int64_t cells = 1;
    double asked = 1;    ///< those in the file times the factor of the level
    int refinement = 1;  ///< layers for each of those that the law is determined with
};

/// A single layer stays one: a grid that is one cell thick is so at every level. Reports listed
/// positions, which cannot be raised.
LayerCount raise_layers(const SweepEntry& entry, const CountRules& rules, Diagnostics& diagnostics);

}  // namespace hexweave
