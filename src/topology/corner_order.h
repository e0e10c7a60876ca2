// SPDX-License-Identifier: Apache-2.0
// In which order corners are listed that were listed in a wrong one.
#pragma once

#include <array>
#include <cstddef>

#include "core/vec3.h"

namespace hexweave {

/// The order of four points of the plane z = 0 counter-clockwise round the largest area, from the
/// first on.
std::array<std::size_t, 4> order_round(const std::array<Vec3, 4>& corners);

/// The order of eight points as a CGNS hexahedron of the shortest edges, right-handed; the first
/// four stay the first four where that is right-handed, else they are the last.
std::array<std::size_t, 8> order_of_hexahedron(const std::array<Vec3, 8>& corners);

}  // namespace hexweave
