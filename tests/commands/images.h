// SPDX-License-Identifier: Apache-2.0
// What is asked of the nodes of a finished grid: whether the two sides of an interface are the
// same, or images of each other, and where those of a family are.
#pragma once

#include <algorithm>
#include <functional>
#include <string>

#include "core/multiblock.h"
#include "core/periodic_image.h"

namespace hexweave::testing {

/// How many nodes of an interface are not, to the bit, the images of those on its other side: by
/// `map` where it is periodic, from whichever of the two sides the map leads to the other, else
/// their very own places.
inline int not_images(const MultiblockGrid& grid, const Interface& interface,
                      const PeriodicMap& map) {
    const PointField& own = grid.zones[static_cast<std::size_t>(interface.zone)].points;
    const PointField& donor = grid.zones[static_cast<std::size_t>(interface.donor)].points;
    int off_there = 0;
    int off_back = 0;
    const IndexBox& box = interface.box;
    for (int k = box.begin[2]; k <= box.end[2]; ++k) {
        for (int j = box.begin[1]; j <= box.end[1]; ++j) {
            for (int i = box.begin[0]; i <= box.end[0]; ++i) {
                const Node n = donor_node(interface, {i, j, k});
                const Vec3 here = own(i, j, k);
                const Vec3 there = donor(n[0], n[1], n[2]);
                if (!((interface.periodic ? image(map, here) : here) == there)) ++off_there;
                if (!((interface.periodic ? image(map, there) : there) == here)) ++off_back;
            }
        }
    }
    return std::min(off_there, off_back);
}

/// Calls look(point) for every node of every patch of a family.
inline void for_each_node(const MultiblockGrid& grid, const std::string& family,
                          const std::function<void(const Vec3&)>& look) {
    for (const BoundaryPatch& patch : grid.patches) {
        if (grid.families[static_cast<std::size_t>(patch.family)].name != family) continue;
        const PointField& x = grid.zones[static_cast<std::size_t>(patch.zone)].points;
        for (int k = patch.box.begin[2]; k <= patch.box.end[2]; ++k)
            for (int j = patch.box.begin[1]; j <= patch.box.end[1]; ++j)
                for (int i = patch.box.begin[0]; i <= patch.box.end[0]; ++i) look(x(i, j, k));
    }
}

}  // namespace hexweave::testing
