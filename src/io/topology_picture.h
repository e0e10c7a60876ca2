// SPDX-License-Identifier: Apache-2.0
// A drawing of a topology as resolved, before anything is solved: vertices, edges with their cells
// and directions, faces with theirs, boundary families by colour, cuts and periodic pairs; of
// blocks also a graph that tells which faces they share.
#pragma once

#include <filesystem>
#include <string>

#include "io/picture.h"
#include "topology/topology.h"

namespace hexweave {

/// Writes the drawing. Throws MachineError when the file cannot be written.
void draw_topology(const Topology& topology, const std::string& title, PictureFormat format,
                   const std::filesystem::path& path);

}  // namespace hexweave
