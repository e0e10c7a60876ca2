// SPDX-License-Identifier: Apache-2.0
// A CGNS file whose points are read box by box, by a process of its own: grids may be larger than
// memory, two files are read at once, and a damaged file ends that process, not this one.
#pragma once

#include <cstddef>
#include <filesystem>

#include "quality/point_source.h"

namespace hexweave {

/// Opens the file and reads its outline. The reading process lives as long as the source's
/// functions; it keeps two pieces in memory that both processes share. Bases after the first,
/// unstructured zones and boundary conditions that cover no rectangle are left out of the outline,
/// and listed among its other nodes. Otherwise throws UsageError as read_cgns does, MachineError
/// when no process can be started.
PointSource open_cgns_pieces(const std::filesystem::path& path, std::size_t piece_nodes);

}  // namespace hexweave
