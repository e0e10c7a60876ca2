// SPDX-License-Identifier: Apache-2.0
// Counts in the making: what edges say, and what holds for each group of parallel ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.h"
#include "topology/adjusted_counts.h"
#include "topology/counts.h"
#include "topology/draft.h"
#include "topology/parallel_edges.h"

namespace hexweave {

/// A count that the user gave to an edge.
using Given = std::optional<Located<int>>;

/// The count of one group of parallel edges, and the face whose sums gave it (-1: a given count).
struct GroupCount {
    std::int64_t cells = 0;  ///< 0: unknown
    int from_face = -1;
    bool faulty = false;  ///< reported
};

struct Counting {
    const Network& network;
    const ParallelEdges& parallels;
    Diagnostics& diagnostics;
    std::vector<Given> given;
    std::vector<int> group_of;
    std::vector<GroupCount> groups;

    GroupCount& group(int edge) {
        return groups[static_cast<std::size_t>(group_of[static_cast<std::size_t>(edge)])];
    }
    std::int64_t cells(int edge) { return group(edge).cells; }
    std::string edge_name(int edge) const { return quoted(network.edge(edge).name); }
    std::string face_name(int face) const { return quoted(network.face(face).name); }
};

/// "1 cell", "2 cells".
std::string cells_text(std::int64_t cells);

/// Raises the counts of all groups, each of which is known, as `rules` ask for. Reports edges of
/// listed points, which cannot be raised, and faces whose sides cannot be made equal.
std::vector<AdjustedCount> adjust_counts(Counting& counting,
                                         const std::vector<SumEquation>& equations,
                                         const CountRules& rules);

}  // namespace hexweave
