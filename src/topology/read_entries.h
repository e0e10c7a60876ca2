// SPDX-License-Identifier: Apache-2.0
// The sections of a file that name things: vertices, edges, faces, blocks, boundaries. Each gives
// an entry for every key, in order. What could not be read of an entry is an empty name (a faulty
// vertex lies on a curve without a name), so that its own name still stands.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "topology/case.h"
#include "topology/read_values.h"

namespace hexweave {

/// What CGNS can hold of the names of zones and families, in bytes.
inline constexpr std::size_t longest_zone_name = 32;

std::vector<VertexEntry> read_vertices(Reading& reading, const YamlNode& section);
std::vector<EdgeEntry> read_edges(Reading& reading, const YamlNode& section);
std::vector<FaceEntry> read_faces(Reading& reading, const YamlNode& section);
std::vector<BlockEntry> read_blocks(Reading& reading, const YamlNode& section);
/// The value of `flat_edge_exponent` in a face, a block or the solver's section, where it is there.
std::optional<double> read_flat_edge_exponent(Reading& reading, const YamlNode& mapping);
/// How far the edges of a face, or the ends of an edge, may be off its surfaces, or an edge off its
/// plane, where it is stated.
std::optional<double> read_gap(Reading& reading, const YamlNode& entry, const std::string& kind);
/// "z = 0": an axis and an expression.
std::optional<AxisPlane> read_axis_plane(Reading& reading, const YamlNode& node);
std::vector<BoundaryEntry> read_boundaries(Reading& reading, const YamlNode& section);

}  // namespace hexweave
