// SPDX-License-Identifier: Apache-2.0
// Whether faces and blocks can hold a grid at all, and whether it is right-handed.
#pragma once

#include "core/diagnostics.h"
#include "topology/draft.h"
#include "topology/topology.h"

namespace hexweave {

/// The volume that the six sides of a block enclose, each a Coons patch between its sampled edges
/// (where it lies on a surface, of their parameters); positive when i, j and k are right-handed.
/// Sound for any shape whose faces do not bulge far from their Coons patches: C- and O-type blocks
/// too.
double signed_volume(const Topology& topology, const Block& block);

/// Reports faces whose sides cross, left-handed faces of a planar grid, left-handed blocks, and
/// those that enclose nothing: false where no grid can be.
bool check_handedness(const Network& network, Diagnostics& diagnostics);

}  // namespace hexweave
