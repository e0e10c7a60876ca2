// SPDX-License-Identifier: Apache-2.0
// Right-handed or not: the signed area of a planar face, the signed volume of a block.
#pragma once

#include "core/diagnostics.h"
#include "topology/draft.h"
#include "topology/topology.h"

namespace hexweave {

/// The area that the sampled sides of a face enclose in the (x, y) plane; positive when i to j
/// turns counter-clockwise seen from +z.
double signed_area(const Topology& topology, const Face& face);

/// The volume that the six sides of a block enclose, each a Coons patch between its sampled edges
/// (where it lies on a surface, of their parameters); positive when i, j and k are right-handed.
/// Sound for any shape whose faces do not bulge far from their Coons patches: C- and O-type blocks
/// too.
double signed_volume(const Topology& topology, const Block& block);

/// Reports left-handed faces of a planar grid, left-handed blocks, and those that enclose nothing:
/// false where there are such.
bool check_handedness(const Network& network, Diagnostics& diagnostics);

}  // namespace hexweave
