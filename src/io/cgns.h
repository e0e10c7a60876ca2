// SPDX-License-Identifier: Apache-2.0
// CGNS files, HDF5-backed. The only header through which the rest of the program knows libcgns and
// HDF5.
#pragma once

#include <filesystem>

#include "core/multiblock.h"

namespace hexweave {

/// Writes the grid with libcgns, then rewrites the file's tree through HDF5 without time stamps and
/// stray bytes, so that equal grids are equal files. `path` is written in place: stage it with
/// OutputFiles first. Throws MachineError (disk full, no permission, a zone too large for the
/// 32-bit sizes of libcgns).
void write_cgns(const MultiblockGrid& grid, const std::filesystem::path& path);

/// Reads any structured CGNS file (HDF5 or ADF): zones in the order of the file, coordinates as
/// doubles, families, boundary conditions (literal types become families of the same name) and
/// one-to-one interfaces, each once. Throws UsageError when the file is missing, not CGNS or not
/// structured.
MultiblockGrid read_cgns(const std::filesystem::path& path);

/// Switches off HDF5's exit handlers, which crash after a full disk. Called first in main.
void prepare_hdf5();

}  // namespace hexweave
