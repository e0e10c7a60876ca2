// SPDX-License-Identifier: Apache-2.0
// CGNS files, HDF5-backed. The only header through which the rest of the program knows libcgns and
// HDF5.
#pragma once

#include <filesystem>

#include "core/multiblock.h"

namespace hexweave {

/// Writes the grid with libcgns, then rewrites the file's tree through HDF5 without time stamps and
/// stray bytes, so that equal grids are equal files. `path` is written in place: call it through
/// OutputFiles::write. Throws MachineError (disk full, no permission, a zone too large for the
/// 32-bit sizes of libcgns) and UsageError (a zone and a family of one name, which CGNS keeps in
/// one list).
///
/// Layout: one base "Base"; title and provenance in the descriptors "Title" and "Provenance"; units
/// on the base and on each coordinate; CoordinateX, Y (and Z in three physical dimensions) as
/// doubles; a Family_t with one FamilyBC_t per family, and for the type "UserDefined" or
/// "UserDefined:NAME" one UserDefinedData_t child (named after the family, or NAME); per patch a
/// BC_t with PointRange, Vertex, FamilySpecified (or the patch's own type) and FamilyName; per
/// interface a GridConnectivity1to1_t on both sides. Zones carry no FamilyName.
void write_cgns(const MultiblockGrid& grid, const std::filesystem::path& path);

/// Reads any structured CGNS file (HDF5 or ADF): zones in the order of libcgns (by name),
/// coordinates as doubles, families, boundary conditions (literal types without a family become
/// families of the same name; one that is not the family's stays with the patch) and one-to-one
/// interfaces, each once, on the side that comes first. Throws UsageError when
/// the file is missing, not CGNS, damaged or not structured, and when the two ends of a periodic
/// interface contradict each other.
MultiblockGrid read_cgns(const std::filesystem::path& path);

/// Switches off HDF5's exit handlers, which crash after a full disk, and lets it work on file
/// systems without locks. Called first in main, before any other use of HDF5.
void prepare_hdf5();

}  // namespace hexweave
