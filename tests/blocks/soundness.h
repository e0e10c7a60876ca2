// SPDX-License-Identifier: Apache-2.0
// What every assembled grid promises of its interfaces and patches, checked on coordinates.
#pragma once

#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/multiblock.h"

namespace hexweave::test {

template <class Visit>
void for_each_node(const IndexBox& box, Visit&& visit) {
    for (int k = box.begin[2]; k <= box.end[2]; ++k) {
        for (int j = box.begin[1]; j <= box.end[1]; ++j) {
            for (int i = box.begin[0]; i <= box.end[0]; ++i) visit(Node{i, j, k});
        }
    }
}

inline IndexBox forwards(IndexBox box) {
    for (std::size_t a = 0; a < 3; ++a) {
        if (box.begin[a] > box.end[a]) std::swap(box.begin[a], box.end[a]);
    }
    return box;
}

inline bool inside(const Node& n, const Extent& e) {
    return n[0] >= 0 && n[0] < e.ni && n[1] >= 0 && n[1] < e.nj && n[2] >= 0 && n[2] < e.nk;
}

inline const PointField& points_of(const MultiblockGrid& grid, int zone) {
    return grid.zones[static_cast<std::size_t>(zone)].points;
}

/// The axis that a box is flat in, where its zone is not.
inline std::size_t flat_axis(const IndexBox& box, const Extent& e) {
    for (std::size_t a = 0; a < 3; ++a) {
        if (box.begin[a] == box.end[a] && e[static_cast<int>(a)] > 1) return a;
    }
    FAIL("the box is not part of a side");
    return 0;
}

inline void check_interface(const MultiblockGrid& grid, const Interface& interface) {
    const PointField& own = points_of(grid, interface.zone);
    const PointField& donor = points_of(grid, interface.donor);
    for (std::size_t a = 0; a < 3; ++a) REQUIRE(interface.box.begin[a] <= interface.box.end[a]);
    CHECK(donor_node(interface, interface.box.begin) == interface.donor_box.begin);
    CHECK(donor_node(interface, interface.box.end) == interface.donor_box.end);
    const std::size_t normal = flat_axis(interface.box, own.extent());
    for_each_node(interface.box, [&](const Node& n) {
        const Node d = donor_node(interface, n);
        REQUIRE(inside(d, donor.extent()));
        REQUIRE(own(n[0], n[1], n[2]) == donor(d[0], d[1], d[2]));
        // One step inwards is one step out of the donor, and the other way about.
        Node inner = n;
        inner[normal] += n[normal] == 0 ? 1 : -1;
        Node outer = n;
        outer[normal] -= n[normal] == 0 ? 1 : -1;
        REQUIRE_FALSE(inside(donor_node(interface, inner), donor.extent()));
        REQUIRE(inside(donor_node(interface, outer), donor.extent()));
    });
}

/// Every cell face on the boundary of every zone belongs to exactly one interface side or patch.
inline void check_coverage(const MultiblockGrid& grid) {
    std::map<std::array<int, 6>, int> covered;  // zone, side, cell
    const auto cover = [&](int zone, IndexBox box) {
        box = forwards(box);
        const Extent e = points_of(grid, zone).extent();
        const std::size_t normal = flat_axis(box, e);
        REQUIRE((box.begin[normal] == 0 || box.begin[normal] == e[static_cast<int>(normal)] - 1));
        const int side = static_cast<int>(2 * normal) + (box.begin[normal] > 0 ? 1 : 0);
        IndexBox cells = box;
        for (std::size_t a = 0; a < 3; ++a) {
            if (a != normal && e[static_cast<int>(a)] > 1) --cells.end[a];
        }
        for_each_node(cells, [&](const Node& n) { ++covered[{zone, side, n[0], n[1], n[2], 0}]; });
    };
    for (const Interface& interface : grid.interfaces) {
        cover(interface.zone, interface.box);
        cover(interface.donor, interface.donor_box);
    }
    for (const BoundaryPatch& patch : grid.patches) cover(patch.zone, patch.box);
    std::size_t expected = 0;
    for (const Zone& zone : grid.zones) {
        const Extent e = zone.points.extent();
        for (int a = 0; a < 3; ++a) {
            if (e[a] > 1) expected += 2 * e.cells() / static_cast<std::size_t>(e[a] - 1);
        }
    }
    CHECK(covered.size() == expected);
    for (const auto& [cell, times] : covered) CHECK(times == 1);
}

inline void check_sound(const MultiblockGrid& grid) {
    std::set<std::string> names;
    for (const Interface& interface : grid.interfaces) {
        check_interface(grid, interface);
        CHECK(determinant(interface.orientation) == 1);
        CHECK(names.insert(interface.name).second);
        CHECK(interface.name.size() <= 32);
    }
    check_coverage(grid);
}

}  // namespace hexweave::test
