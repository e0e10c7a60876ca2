// SPDX-License-Identifier: Apache-2.0
// A grid as VTK's XML files (ParaView, VisIt, PyVista): a .vtm file that lists, in a block "zones"
// and in one block per family under "boundaries", structured grids (.vts) in a folder beside it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/multiblock.h"

namespace hexweave {

/// A text that goes with a grid.
struct VtkText {
    std::string name;
    std::string text;
};

/// One structured grid: a zone, or the nodes of a boundary patch.
struct VtkPiece {
    std::string file;  ///< "zone1.vts", "patch1.vts"
    int zone = 0;
    IndexBox box;
    int patch = -1;  ///< -1: the whole zone
};

/// The zones, then the patches, each in the order of the grid.
std::vector<VtkPiece> vtk_pieces(const MultiblockGrid& grid);

/// A value for every cell of a grid, i fastest.
struct VtkCellArray {
    std::string name;
    const std::vector<double>& values;
};

/// Writes a grid on its own (.vts) with values at its cells and texts as field data. Throws
/// MachineError.
void write_vtk_grid(const PointField& points, const std::vector<VtkText>& texts,
                    const std::vector<VtkCellArray>& cells, const std::filesystem::path& path);

/// Writes one piece: points as doubles, appended raw; names and units as field data (Zone and
/// Units; Patch, Family and Type on patches). Throws MachineError.
void write_vtk_piece(const MultiblockGrid& grid, const VtkPiece& piece,
                     const std::filesystem::path& path);

/// Writes the list of pieces, which stand in `folder` beside it. Throws MachineError.
void write_vtk_index(const MultiblockGrid& grid, const std::vector<VtkPiece>& pieces,
                     const std::string& folder, const std::filesystem::path& path);

}  // namespace hexweave
