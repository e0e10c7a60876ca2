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
#include "io/file_uses.h"
#include "io/output_files.h"

namespace hexweave {

/// Reads CGNS (.cgns, and HDF5 or ADF files of any other name) and Plot3D (see plot3d_endings),
/// with the neutral map file of the same stem (grid.nmf beside grid.xyz) where there is one.
/// `format` overrules the name. Throws UsageError, also where a coordinate is not a finite number.
MultiblockGrid read_grid(const std::filesystem::path& path,
                         std::optional<GridFormat> format = std::nullopt);

/// Whether this is the beginning of an HDF5 or ADF file, whatever it is called.
bool begins_as_cgns(std::string_view text);
bool file_begins_as_cgns(const std::filesystem::path& path);

/// The format of a file that is to be read. Throws UsageError for a config, and where neither name
/// nor contents tell.
GridFormat format_to_read(const std::filesystem::path& path);

/// "cannot write 'x.txt': ...", with the endings that are known.
std::string unknown_ending(const std::string& path);

/// What a path says about the format and, for Plot3D, the form; nothing for an unknown ending.
std::optional<GridOutput> output_by_name(const std::string& path);

/// An output for which a place is reserved: its folders are there, its first files are staged.
struct ReservedOutput {
    GridOutput output;
    std::vector<std::filesystem::path> staged;
};

/// Where an output is written. Plot3D stands in two files (its map beside it, ending in .nmf), VTK
/// in a .vtm file and a folder of its stem, OpenFOAM in constant/polyMesh under the case's folder;
/// for a path that ends in .foam the case is the folder of that file, which ParaView opens and
/// which is empty. `role` is what the output is to the command.
std::vector<FileUse> files_written(const GridOutput& output, const std::string& role);

/// What read_grid looks at; the map may not be there.
std::vector<FileUse> files_read(const std::filesystem::path& path, const std::string& role,
                                std::optional<GridFormat> format = std::nullopt);

/// To be called before the grid is made, so that what cannot be written is told at once.
ReservedOutput reserve(const GridOutput& output, OutputFiles& files);

/// Writes the grid; `files` is to be committed after it.
void write_grid(const MultiblockGrid& grid, const ReservedOutput& reserved, OutputFiles& files);

}  // namespace hexweave
