// SPDX-License-Identifier: Apache-2.0
// Extrusion, revolution and mirroring of the whole grid, as resolved.
#pragma once

#include "core/diagnostics.h"
#include "topology/counts.h"
#include "topology/draft.h"

namespace hexweave {

/// Fills the sweep but for the boundaries of its ends, its cells raised as those of edges are. Puts
/// what a revolution collapses exactly onto its axis. Reports grids that are not planar or on both
/// sides of the axis, laws that do not fit, and periodic interfaces that a sweep does not keep.
void place_sweep(Network& network, const Case& c, const CountRules& rules,
                 Diagnostics& diagnostics);

/// Finds the boundaries of the sweep's ends; ends that have none are told in a warning and go to
/// the family `unassigned`. After resolve_boundaries.
void resolve_sweep_ends(Network& network, const Case& c, Diagnostics& diagnostics);

/// Fills the mirrored copy. Reports a boundary that is unknown, without sides or without a plane,
/// a plane that a revolution does not keep, and names that the copies cannot have.
void resolve_mirror(Network& network, const Case& c, Diagnostics& diagnostics);

}  // namespace hexweave
