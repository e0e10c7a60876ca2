// SPDX-License-Identifier: Apache-2.0
// In which order corners are listed that were listed in a wrong one.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "core/vec3.h"
#include "topology/topology.h"

namespace hexweave {

/// The order of four points of the plane z = 0 counter-clockwise round the largest area, from the
/// first on.
std::array<std::size_t, 4> order_round(const std::array<Vec3, 4>& corners);

/// The order of eight points as a CGNS hexahedron of the shortest edges, right-handed; the first
/// four stay the first four where that is right-handed, else they are the last.
std::array<std::size_t, 8> order_of_hexahedron(const std::array<Vec3, 8>& corners);

/// Where the vertices of a face or block are.
template <std::size_t count>
std::array<Vec3, count> positions(const Topology& topology,
                                  const std::array<int, count>& vertices) {
    std::array<Vec3, count> points;
    for (std::size_t n = 0; n < count; ++n) {
        points.at(n) = topology.vertices[static_cast<std::size_t>(vertices.at(n))].position;
    }
    return points;
}

/// Whether an order leaves everything where it is.
template <std::size_t count>
bool is_as_listed(const std::array<std::size_t, count>& order) {
    for (std::size_t n = 0; n < count; ++n) {
        if (order.at(n) != n) return false;
    }
    return true;
}

/// The corners of an entry in an order: "a, b, c, d".
template <std::size_t count>
std::string corner_list(const std::array<Name, count>& corners,
                        const std::array<std::size_t, count>& order) {
    std::string text;
    for (const std::size_t n : order) {
        text += (text.empty() ? "" : ", ") + corners.at(n).value;
    }
    return text;
}

}  // namespace hexweave
