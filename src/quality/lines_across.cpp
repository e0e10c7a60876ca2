// SPDX-License-Identifier: Apache-2.0
#include "quality/lines_across.h"

#include <cstddef>
#include <optional>

#include "core/periodic_image.h"

namespace hexweave {

namespace {

Vec3 at(const PointField& x, const Node& n) {
    return x(n[0], n[1], n[2]);
}

/// Of a box that is a part of a side of a zone: the step of nodes from the side into the zone.
Node inward_step(const IndexBox& box, const Extent& extent) {
    Node step{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int last = extent[static_cast<int>(axis)] - 1;
        if (last == 0 || box.begin[axis] != box.end[axis]) continue;
        step[axis] = box.begin[axis] == 0 ? 1 : -1;
        break;
    }
    return step;
}

Node operator+(const Node& a, const Node& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

}  // namespace

void for_lines_across(const MultiblockGrid& grid, const Interface& interface,
                      const std::function<void(const Vec3&, const Vec3&, const Vec3&)>& visit) {
    const PointField& own = grid.zones[static_cast<std::size_t>(interface.zone)].points;
    const PointField& donor = grid.zones[static_cast<std::size_t>(interface.donor)].points;
    std::optional<PeriodicMap> map;
    if (interface.periodic) map = periodic_map(*interface.periodic);
    const IndexBox& box = interface.box;
    const Node inward = inward_step(box, own.extent());
    const Node onward = inward_step(interface.donor_box, donor.extent());
    for (int k = box.begin[2]; k <= box.end[2]; ++k) {
        for (int j = box.begin[1]; j <= box.end[1]; ++j) {
            for (int i = box.begin[0]; i <= box.end[0]; ++i) {
                const Node n{i, j, k};
                const Node m = donor_node(interface, n);
                const Vec3 before = at(own, n + inward);
                const Vec3 behind = at(donor, m + onward);
                if (map) {
                    const Vec3 here = at(donor, m);
                    visit(here + image_of_way(*map, before - at(own, n)), here, behind);
                } else {
                    visit(before, at(own, n), behind);
                }
            }
        }
    }
}

}  // namespace hexweave
