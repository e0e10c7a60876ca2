// SPDX-License-Identifier: Apache-2.0
// What the JSON of a run tells of a finished grid: nothing, unless the run made that grid.
#pragma once

#include <cstddef>
#include <string>

#include "core/multiblock.h"

namespace hexweave {

struct RunOfGrid {
    std::string json = "null";     ///< one object: config, parameters, gates, solves, spacings
    std::size_t missed_gates = 0;  ///< of the grid
};

/// `text` is what `hexweave run --json` wrote to the file `path`; of several levels the one with
/// the grid's zones is meant. Throws UsageError, naming the file, for a text that is none, and for
/// a run whose grids have other zones, or zones of other sizes.
RunOfGrid run_of_grid(const std::string& text, const std::string& path, const MultiblockGrid& grid);

}  // namespace hexweave
