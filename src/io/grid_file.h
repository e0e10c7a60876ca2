// SPDX-License-Identifier: Apache-2.0
// Grids in files of any format that hexweave knows: which format a file has, reading it, writing
// it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/grid_output.h"
#include "core/multiblock.h"

namespace hexweave {

/// Reads CGNS (.cgns, and HDF5 or ADF files of any other name) and Plot3D (see plot3d_endings),
/// with the neutral map file of the same stem (grid.nmf beside grid.xyz) where there is one.
/// `format` overrules the name. Throws UsageError.
MultiblockGrid read_grid(const std::filesystem::path& path,
                         std::optional<GridFormat> format = std::nullopt);

}  // namespace hexweave
