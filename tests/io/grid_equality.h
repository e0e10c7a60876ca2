// SPDX-License-Identifier: Apache-2.0
// Grids that came through a file are the grids that went in, to the bit.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>

#include "core/multiblock.h"

namespace hexweave {

inline bool same_bits(const Field& a, const Field& b) {
    return a.extent() == b.extent() &&
           std::memcmp(a.data(), b.data(), a.extent().nodes() * sizeof(double)) == 0;
}

inline void check_same_points(const MultiblockGrid& grid, const MultiblockGrid& expected) {
    CHECK(grid.cell_dimension == expected.cell_dimension);
    CHECK(grid.physical_dimension == expected.physical_dimension);
    REQUIRE(grid.zones.size() == expected.zones.size());
    for (std::size_t zone = 0; zone < grid.zones.size(); ++zone) {
        INFO("zone " << zone);
        const PointField& points = grid.zones[zone].points;
        const PointField& wanted = expected.zones[zone].points;
        REQUIRE(points.extent() == wanted.extent());
        CHECK(same_bits(points.x, wanted.x));
        CHECK(same_bits(points.y, wanted.y));
        CHECK(same_bits(points.z, wanted.z));
    }
}

inline void check_same_grid(const MultiblockGrid& grid, const MultiblockGrid& expected) {
    check_same_points(grid, expected);
    CHECK(grid.title == expected.title);
    CHECK(grid.units == expected.units);
    CHECK(grid.provenance == expected.provenance);
    for (std::size_t zone = 0; zone < grid.zones.size(); ++zone) {
        CHECK(grid.zones[zone].name == expected.zones[zone].name);
    }
    REQUIRE(grid.interfaces.size() == expected.interfaces.size());
    for (std::size_t n = 0; n < grid.interfaces.size(); ++n) {
        const Interface& a = grid.interfaces[n];
        const Interface& b = expected.interfaces[n];
        CHECK(a.name == b.name);
        CHECK(a.zone == b.zone);
        CHECK(a.donor == b.donor);
        CHECK(a.box == b.box);
        CHECK(a.donor_box == b.donor_box);
        CHECK(a.orientation == b.orientation);
        REQUIRE(a.periodic.has_value() == b.periodic.has_value());
        if (!a.periodic) continue;
        CHECK(a.periodic->center == b.periodic->center);
        CHECK(a.periodic->angle == b.periodic->angle);
        CHECK(a.periodic->translation == b.periodic->translation);
    }
    REQUIRE(grid.families.size() == expected.families.size());
    for (std::size_t n = 0; n < grid.families.size(); ++n) {
        CHECK(grid.families[n].name == expected.families[n].name);
        CHECK(grid.families[n].type == expected.families[n].type);
    }
    REQUIRE(grid.patches.size() == expected.patches.size());
    for (std::size_t n = 0; n < grid.patches.size(); ++n) {
        CHECK(grid.patches[n].name == expected.patches[n].name);
        CHECK(grid.patches[n].zone == expected.patches[n].zone);
        CHECK(grid.patches[n].box == expected.patches[n].box);
        CHECK(grid.patches[n].family == expected.patches[n].family);
        CHECK(grid.patches[n].type == expected.patches[n].type);
    }
}

}  // namespace hexweave
