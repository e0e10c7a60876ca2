// SPDX-License-Identifier: Apache-2.0
// What other programs make of our files.
#include <catch2/catch.hpp>
#include <map>

#include "io/cgns.h"
#include "io/cgns_samples.h"
#include "io/scratch.h"

using namespace hexweave;

namespace {

MultiblockGrid without_units(MultiblockGrid grid) {
    grid.units.clear();
    return grid;
}

const std::map<std::string, MultiblockGrid>& samples() {
    static const std::map<std::string, MultiblockGrid> all{
        {"planar", joined_pair(2, 2, rotations(2)[1])},
        {"surface", joined_pair(2, 3, rotations(2)[2])},
        {"volume", joined_pair(3, 3, rotations(3)[7])},
        {"cut", c_grid()},
        {"unitless", without_units(c_grid())},
        {"row", row_of_zones(12, 4)}};
    return all;
}

/// Leaves freed memory behind that is full of `byte`.
void litter(char byte) {
    std::vector<std::vector<char>> pieces;
    for (std::size_t size = 16; size < 100000; size += size / 2) {
        for (int n = 0; n < 20; ++n) pieces.emplace_back(size, byte);
    }
    CHECK(pieces.back().back() == byte);
}

std::string arguments(const MultiblockGrid& grid) {
    std::string text = " --zones";
    for (const Zone& zone : grid.zones) {
        const Extent& e = zone.points.extent();
        text += " " + zone.name + "=" + std::to_string(e.ni) + "x" + std::to_string(e.nj) + "x" +
                std::to_string(e.nk);
    }
    if (grid.cell_dimension == 3) {
        text += " --families";
        for (const Family& family : grid.families) text += " " + family.name;
    }
    return text;
}

}  // namespace

TEST_CASE("Equal grids are equal files, whatever the memory held before") {
    const Scratch scratch;
    for (const auto& [name, grid] : samples()) {
        INFO(name);
        litter('\x55');
        write_cgns(grid, scratch.path("one"));
        litter('\xaa');
        write_cgns(grid, scratch.path("other"));
        const std::string one = contents(scratch.path("one"));
        REQUIRE(one.size() > 1000);
        CHECK(one == contents(scratch.path("other")));
    }
}

TEST_CASE("Equal grids are equal files from one process to the next") {
    const Scratch scratch;
    const std::string probe = std::string(HEXWEAVE_WRITE_PROBE) + " 3 5 ";
    REQUIRE(run(probe + scratch.path("one").string()).status == 0);
    REQUIRE(run("sleep 1; MALLOC_PERTURB_=165 " + probe + scratch.path("other").string()).status ==
            0);
    CHECK(contents(scratch.path("one")) == contents(scratch.path("other")));
}

TEST_CASE("cgnscheck has nothing to say about our files") {
    const Scratch scratch;
    for (const auto& [name, grid] : samples()) {
        const std::filesystem::path path = scratch.path(name + ".cgns");
        write_cgns(grid, path);
        const Outcome outcome = run("cgnscheck " + path.string());
        INFO(outcome.output);
        CHECK(outcome.status == 0);
        CHECK(outcome.output.find("checking complete") != std::string::npos);
        CHECK(outcome.output.find("ERROR") == std::string::npos);
        CHECK(outcome.output.find("WARNING") == std::string::npos);
    }
}

TEST_CASE("The tree of a file is what solvers look for") {
    const Scratch scratch;
    write_cgns(c_grid(), scratch.path("c.cgns"));
    const Outcome outcome = run("cgnslist " + scratch.path("c.cgns").string());
    CHECK(outcome.status == 0);
    for (const char* node :
         {"+-Base", "+-Title", "+-Provenance", "+-DimensionalUnits", "+-DimensionalExponents",
          "+-BCOverset", "+-FamBC", "+-PointRangeDonor", "+-Transform", "+-GridLocation",
          "+-FamilyName", "+-wake_2"}) {
        INFO(node << "\n" << outcome.output);
        CHECK(outcome.output.find(node) != std::string::npos);
    }
}

TEST_CASE("VTK finds the zones, patches and families") {
    const Scratch scratch;
    for (const auto& [name, grid] : samples()) {
        const std::filesystem::path path = scratch.path(name + ".cgns");
        write_cgns(grid, path);
        const Outcome outcome =
            run("/usr/bin/python3 " HEXWEAVE_SOURCE_DIR "/tests/tools/vtk_check.py " +
                path.string() + arguments(grid));
        if (outcome.status == 77) {
            WARN(outcome.output);
            return;
        }
        INFO(outcome.output);
        CHECK(outcome.status == 0);
    }
}
