// SPDX-License-Identifier: Apache-2.0
// The spine: one run, from the text of a case to a finished grid and its measures.
#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "core/diagnostics.h"
#include "core/multiblock.h"
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

/// Stages 1 and 2: reads and resolves. Throws InputError, with every fault of both, when there are
/// errors; warnings are left in `diagnostics`.
Topology read_topology(const std::shared_ptr<const SourceFile>& source,
                       const std::vector<Override>& overrides, Diagnostics& diagnostics);

/// Stages 3 to 6: edges, faces, blocks, the assembled grid, its measures.
Generated generate(const Topology& topology, const Progress& progress);

}  // namespace hexweave
