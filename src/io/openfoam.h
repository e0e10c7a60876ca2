// SPDX-License-Identifier: Apache-2.0
// The mesh of an OpenFOAM case: five text files in constant/polyMesh, with the shortest decimals
// that give the same doubles back.
#pragma once

#include <array>
#include <filesystem>

#include "io/poly_mesh.h"

namespace hexweave {

/// The files of a mesh, in the order in which write_poly_mesh takes their paths.
inline constexpr std::array<const char*, 5> poly_mesh_files{"points", "faces", "owner", "neighbour",
                                                            "boundary"};

/// Throws MachineError.
void write_poly_mesh(const PolyMesh& mesh, const std::array<std::filesystem::path, 5>& paths);

}  // namespace hexweave
