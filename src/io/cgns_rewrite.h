// SPDX-License-Identifier: Apache-2.0
// What libcgns leaves in an HDF5 file besides the grid: the time of creation of every object, and
// whatever stood in memory behind the end of a short name. This pass copies the tree without them,
// so that equal grids are equal files.
#pragma once

#include <filesystem>

namespace hexweave {

/// Copies the tree of the HDF5 file `from` into `to`, which is created or overwritten. Throws
/// MachineError in the name of `shown`.
void rewrite_cgns_tree(const std::filesystem::path& from, const std::filesystem::path& to,
                       const std::filesystem::path& shown);

}  // namespace hexweave
