// SPDX-License-Identifier: Apache-2.0
// How the factors by which heights at a wall are off those asked go on away from the wall. The
// logarithm of the height of a conformal grid is a harmonic function, and so is what corrects it:
// what is rough along the wall at a length l is gone at a distance l from it. A factor that were
// carried outwards as it is would print every corner of the wall upon the lines far from it.
#pragma once

#include "core/field.h"
#include "faces/wall_frame.h"

namespace hexweave {

/// The factors at the nodes n steps off a wall, over the wall's own two axes.
struct FactorLayer {
    Field log_factors;
    Field widening;  ///< of the squared distance from the wall, from the layer before to this one

    explicit FactorLayer(const WallFrame& wall)
        : log_factors(wall.nodes()), widening(wall.nodes()) {}
};

/// From the factors of layer n - 1 those of layer n: an implicit step of diffusion along the
/// layer's lines, those along a and along b - the mean of either order, so that the axes may change
/// places - by a quarter of `widening`, so that all
/// steps to a distance r together weigh the factors at the wall by a bell of variance r^2 / 2, and
/// no factor is beyond those about it. Nodes at the ends of the wall keep theirs, and so do all
/// where `widening` is 0.
void smooth_along_wall(FactorLayer& layer, const PointField& points, const WallFrame& wall, int n);

}  // namespace hexweave
