// SPDX-License-Identifier: Apache-2.0
// The neutral map file (NASA Langley, GEOLAB): what joins and bounds the blocks of a Plot3D file.
//
// Faces are numbered 1 kmin, 2 kmax, 3 imin, 4 imax, 5 jmin, 6 jmax; the primary and secondary
// directions of a face are (i, j), (j, k) and (k, i). A line is a type, then for one face (two for
// ONE_TO_ONE) block, face, and first and last node along either direction; Swap is TRUE when the
// primary direction of the first face runs along the secondary one of the second.
#pragma once

#include <filesystem>

#include "core/multiblock.h"

namespace hexweave {

/// Writes the interfaces as ONE_TO_ONE (periodic ones as PERIODIC, with what carries one side onto
/// the other in a comment) and each patch under the name of its family. What the format
/// has no place for (title, units, provenance, names of zones, patches and interfaces, types of
/// families, patches of another type than theirs) stands in comments that begin with "# hexweave:",
/// which read_neutral_map understands. Throws MachineError, and UsageError for a family with a name
/// that the format cannot hold.
void write_neutral_map(const MultiblockGrid& grid, const std::filesystem::path& path);

/// Adds to a grid read from Plot3D what its map says. A surface may have the map of the same
/// grid drawn one or two nodes thick in some direction, which is left out then.
/// Families that no comment explains get their type by the words that NASA's programs use, else
/// UserDefined. Throws UsageError, with the line, when the map cannot be understood or is that of
/// another grid.
void read_neutral_map(const std::filesystem::path& path, MultiblockGrid& grid);

}  // namespace hexweave
