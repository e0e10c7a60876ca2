// SPDX-License-Identifier: Apache-2.0
// The spine: one run, from the text of a case to a finished grid and its measures.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "blocks/block_grid.h"
#include "core/diagnostics.h"
#include "core/multiblock.h"
#include "edges/edge_grid.h"
#include "faces/face_grid.h"
#include "quality/offenders.h"
#include "quality/report.h"
#include "topology/read_case.h"
#include "topology/topology.h"

namespace hexweave {

/// Told while a stage runs: its name, how many of its parts are done, and how many there are.
using Progress = std::function<void(std::string_view stage, std::size_t done, std::size_t total)>;

struct Generated {
    MultiblockGrid grid;
    Report report;
    std::vector<Offender> offenders;  ///< faces and blocks that ended folded or unconverged
};

/// Points of everything that a topology is made of.
struct Solved {
    std::vector<EdgeGrid> edges;
    std::vector<FaceGrid> faces;
    std::vector<BlockGrid> blocks;
    std::vector<StageTime> stages;
};

/// Stages 1 and 2: reads and resolves. Throws InputError, with every fault of both, when there are
/// errors; warnings are left in `diagnostics`.
Topology read_topology(const std::shared_ptr<const SourceFile>& source,
                       const std::vector<Override>& overrides, Diagnostics& diagnostics);

/// Stages 3 to 5: edges, faces, blocks.
Solved solve(const Topology& topology, const Progress& progress);

/// Stage 6: the assembled grid and its measures.
Generated finish(const Topology& topology, const Solved& solved);
/// The same of one level of a family: of the level that was solved, or of every 2nd, 4th, ... point
/// of it.
Generated finish(const Topology& topology, const Solved& solved, std::size_t level);

/// Stages 3 to 6: the grid of a topology; of a family, of the level that was asked for.
Generated generate(const Topology& topology, const Progress& progress);

}  // namespace hexweave
