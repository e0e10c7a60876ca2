// SPDX-License-Identifier: Apache-2.0
// A grid and its mirror image as one grid.
#pragma once

#include "core/multiblock.h"
#include "topology/topology.h"

namespace hexweave {

/// The grid with the mirror image of every zone, called NAME_mirror and run through backwards along
/// i, so that it is right-handed too. Points on the plane are those of the grid to the bit; the
/// patches of the boundary there become one-to-one interfaces, and its family is left out. The
/// images of other patches belong to the same families, or to families NAME_mirror.
/// Precondition: the patches of the boundary lie on the plane exactly.
MultiblockGrid with_mirror_image(const MultiblockGrid& half, const MirrorCopy& mirror);

}  // namespace hexweave
