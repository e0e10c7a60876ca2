// SPDX-License-Identifier: Apache-2.0
#include "io/cgns.h"

#include <catch2/catch.hpp>
#include <cstring>

#include "io/cgns_samples.h"
#include "io/scratch.h"

using namespace hexweave;

namespace {

bool same_bits(const Field& a, const Field& b) {
    return a.extent() == b.extent() &&
           std::memcmp(a.data(), b.data(), a.extent().nodes() * sizeof(double)) == 0;
}

void require_same(const MultiblockGrid& read, const MultiblockGrid& written) {
    CHECK(read.title == written.title);
    CHECK(read.units == written.units);
    CHECK(read.provenance == written.provenance);
    CHECK(read.cell_dimension == written.cell_dimension);
    CHECK(read.physical_dimension == written.physical_dimension);
    REQUIRE(read.zones.size() == written.zones.size());
    for (std::size_t z = 0; z < read.zones.size(); ++z) {
        CHECK(read.zones[z].name == written.zones[z].name);
        CHECK(same_bits(read.zones[z].points.x, written.zones[z].points.x));
        CHECK(same_bits(read.zones[z].points.y, written.zones[z].points.y));
        CHECK(same_bits(read.zones[z].points.z, written.zones[z].points.z));
    }
    REQUIRE(read.families.size() == written.families.size());
    for (std::size_t f = 0; f < read.families.size(); ++f) {
        CHECK(read.families[f].name == written.families[f].name);
        CHECK(read.families[f].type == written.families[f].type);
    }
    REQUIRE(read.patches.size() == written.patches.size());
    for (std::size_t p = 0; p < read.patches.size(); ++p) {
        CHECK(read.patches[p].name == written.patches[p].name);
        CHECK(read.patches[p].zone == written.patches[p].zone);
        CHECK(read.patches[p].box == written.patches[p].box);
        CHECK(read.patches[p].family == written.patches[p].family);
    }
    REQUIRE(read.interfaces.size() == written.interfaces.size());
    for (std::size_t n = 0; n < read.interfaces.size(); ++n) {
        CHECK(read.interfaces[n].name == written.interfaces[n].name);
        CHECK(read.interfaces[n].zone == written.interfaces[n].zone);
        CHECK(read.interfaces[n].box == written.interfaces[n].box);
        CHECK(read.interfaces[n].donor == written.interfaces[n].donor);
        CHECK(read.interfaces[n].donor_box == written.interfaces[n].donor_box);
        CHECK(read.interfaces[n].orientation == written.interfaces[n].orientation);
    }
}

void require_round_trip(const MultiblockGrid& grid) {
    const Scratch scratch;
    write_cgns(grid, scratch.path("g.cgns"));
    require_same(read_cgns(scratch.path("g.cgns")), grid);
    CHECK(scratch.names() == std::vector<std::string>{"g.cgns"});
}

}  // namespace

TEST_CASE("A planar grid comes back to the bit, whichever way its zones are turned") {
    for (const Orientation& o : rotations(2)) require_round_trip(joined_pair(2, 2, o));
}

TEST_CASE("A surface grid comes back to the bit, whichever way its zones are turned") {
    for (const Orientation& o : rotations(2)) require_round_trip(joined_pair(2, 3, o));
}

TEST_CASE("A volume grid comes back to the bit, in all 24 positions of a neighbour") {
    REQUIRE(rotations(3).size() == 24);
    for (const Orientation& o : rotations(3)) require_round_trip(joined_pair(3, 3, o));
}

TEST_CASE("A cut in one zone and families of every kind come back") {
    require_round_trip(c_grid());
}
