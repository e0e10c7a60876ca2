// SPDX-License-Identifier: Apache-2.0
// Ports of instances made one with what they are joined to: the entity outside stays, the one
// inside goes, and whatever names it names the other.
#pragma once

#include "topology/case.h"
#include "topology/instances.h"

namespace hexweave {

/// An edge brings its two vertices, a face its edges and vertices. The edge outside keeps its
/// curve; of cells and spacing it takes over what it does not say. Told are unknown names, parts of
/// different kinds, counts that differ, and what does not lie in the same place, with how far it is
/// off. Names of ports stand for their parts among the sides of boundaries.
void join_ports(Case& c, const Instances& instances, Diagnostics& diagnostics);

/// Boundaries of one name, of several instances or the case, as one.
void merge_families(Case& c, Diagnostics& diagnostics);

}  // namespace hexweave
