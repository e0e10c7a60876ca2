// SPDX-License-Identifier: Apache-2.0
// A planar grid swept into space: by extrusion or revolution.
#pragma once

#include "core/multiblock.h"
#include "topology/topology.h"

namespace hexweave {

/// The grid with every zone swept, k from layer to layer, right-handed. The first plane is the
/// planar grid to the bit, the last one its image by the map that a periodic interface between the
/// two would have. Patches and interfaces are swept with their sides; the ends become patches of
/// their boundaries, or interfaces where they are joined.
MultiblockGrid swept(const MultiblockGrid& planar, const Sweep& sweep);

}  // namespace hexweave
