// SPDX-License-Identifier: Apache-2.0
// Boundaries: which sides of the grid belong to which family, and which lie on a plane.
#pragma once

#include "core/diagnostics.h"
#include "topology/draft.h"

namespace hexweave {

/// The family of free sides that no boundary names.
inline constexpr const char* unassigned_family = "unassigned";

/// The families of the free sides that are collapsed to a line, and to a point.
inline constexpr const char* line_family = "pole_line";
inline constexpr const char* point_family = "pole_point";

/// Fills the boundaries. Reports sides that more than two faces (blocks) share, boundaries on
/// interior sides or named twice, and warns of free sides that no boundary names: they go to the
/// family `unassigned`. Poles that no boundary names go to families of their own: collapsed to a
/// line to `pole_line` (BCDegenerateLine), to a point to `pole_point` (BCDegeneratePoint).
void resolve_boundaries(Network& network, const Case& c, Diagnostics& diagnostics);

/// Checks that the edges with a plane lie on it as near as their `gap` allows, and those of
/// symmetry planes' sides to 1e-9 of the grid's size; moves their vertices exactly there, and tells
/// edges and faces of their planes.
void resolve_planes(Network& network, const Case& c, Diagnostics& diagnostics);

/// Moves the vertices of edges that lie on planes exactly there.
void put_vertices_onto_planes(Network& network);
/// Straight lines follow vertices that were moved.
void straighten(Network& network);

}  // namespace hexweave
