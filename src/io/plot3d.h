// SPDX-License-Identifier: Apache-2.0
// Plot3D grid files (NASA): the sizes of all blocks, then for each block all x, all y, all z, i
// fastest. What joins and bounds the blocks stands in a neutral map file (io/neutral_map.h).
#pragma once

#include <filesystem>

#include "core/grid_output.h"
#include "core/multiblock.h"

namespace hexweave {

/// Writes a multiblock file in double precision without blanking, with x and y alone where the
/// grid has two physical dimensions. Text holds the shortest decimals that give the same doubles
/// back. An unformatted file has three kinds of records: the number of blocks, all sizes, and one
/// for each block; one longer than 2^31 - 9 bytes is cut into subrecords, as gfortran and ifort do.
/// `path` is written in place: stage it with OutputFiles first. Throws MachineError.
void write_plot3d(const MultiblockGrid& grid, const std::filesystem::path& path, Plot3dForm form,
                  ByteOrder byte_order);

/// Reads a file of one or many blocks, in two or three dimensions, of text (also with Fortran's
/// repeat counts and D exponents) or bytes of either order, unformatted or bare, in single or
/// double precision, with blanking where it blanks nothing out: all found out by the sizes. Zones
/// are called block1, block2, ... (with as many digits as the last has). Blocks one node thick are
/// surfaces, whose i and j are the two axes left. Throws UsageError when the
/// file is missing or holds anything else.
MultiblockGrid read_plot3d(const std::filesystem::path& path);

}  // namespace hexweave
