// SPDX-License-Identifier: Apache-2.0
// What --level asks for: one grid of the family that a config describes, or all of them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "commands/case_options.h"
#include "io/file_uses.h"
#include "topology/case.h"
#include "topology/topology.h"

namespace hexweave {

/// A topology that is solved once, and the levels that are made of it; none where there is no
/// family: then the topology is the grid.
struct LevelGrids {
    Topology solved;
    std::vector<std::size_t> levels;

    /// Of each grid that is made, coarsest first.
    std::vector<Topology> topologies() const;
};

/// Resolves a case at the level that it names, at that of --level, or, with `all`, at every one.
/// Throws InputError as `resolve`, and UsageError for a level that there is not.
std::vector<LevelGrids> resolve_levels(const Case& written, const std::string& level,
                                       Diagnostics& diagnostics);

/// What a config comes to, and the files that say so.
struct CaseGrids {
    std::vector<FileUse> read;
    std::vector<LevelGrids> grids;
};

/// Reads and resolves the config of a command, and settles its warnings; notes what is planned.
CaseGrids read_grids(const CaseOptions& options, Outcome& outcome);

}  // namespace hexweave
