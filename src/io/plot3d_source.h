// SPDX-License-Identifier: Apache-2.0
// A Plot3D file while it is read: the whole of a text as numbers, or the bytes of a file, record by
// record.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/grid_output.h"
#include "core/multiblock.h"
#include "io/plot3d_layout.h"

namespace hexweave {

[[noreturn]] void cannot_read(const std::filesystem::path& path, const std::string& fact);

/// All numbers of a text: separated by white space or commas, with Fortran's repeat counts (3*0.5)
/// and D exponents. Throws UsageError, with the line, at anything else.
std::vector<double> read_numbers(const std::filesystem::path& path);

/// The layout that a text of these numbers has, and the grid in it.
MultiblockGrid read_plot3d_text(const std::filesystem::path& path);

/// The layout that these bytes have, and the grid in them.
MultiblockGrid read_plot3d_bytes(const std::filesystem::path& path);

/// A grid with zones of these sizes and without points. Throws UsageError when hexweave has no such
/// grids: blocks one node thick along i or j, or some along k and some not.
MultiblockGrid empty_grid(const std::filesystem::path& path, const Plot3dLayout& layout);

/// The message for a file whose length fits no layout.
[[noreturn]] void fits_no_layout(const std::filesystem::path& path);
/// The message for blocks with holes.
[[noreturn]] void has_holes(const std::filesystem::path& path, const std::string& zone);

}  // namespace hexweave
