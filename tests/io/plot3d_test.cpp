// SPDX-License-Identifier: Apache-2.0
// Plot3D files and neutral maps: round trips, files of other programs, damaged files.
#include <catch2/catch.hpp>
#include <cstdint>
#include <limits>

#include "core/errors.h"
#include "io/cgns.h"
#include "io/cgns_samples.h"
#include "io/grid_equality.h"
#include "io/grid_file.h"
#include "io/neutral_map.h"
#include "io/plot3d.h"
#include "io/scratch.h"

using namespace hexweave;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

void write_both(const MultiblockGrid& grid, const std::filesystem::path& path, Plot3dForm form,
                ByteOrder order = ByteOrder::little) {
    write_plot3d(grid, path, form, order);
    std::filesystem::path map = path;
    write_neutral_map(grid, map.replace_extension(".nmf"));
}

std::vector<MultiblockGrid> samples() {
    return {joined_pair(2, 2, rotations(2)[1]), joined_pair(2, 3, rotations(2)[2]),
            joined_pair(3, 3, rotations(3)[7]), c_grid(), row_of_zones(12, 4)};
}

template <class Number>
void add(std::string& bytes, Number value, bool swap = false) {
    const auto* first = reinterpret_cast<const char*>(&value);
    std::string piece(first, first + sizeof value);
    if (swap) std::reverse(piece.begin(), piece.end());
    bytes += piece;
}

std::string error_of(const std::filesystem::path& path) {
    try {
        read_grid(path);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("A grid comes back to the bit from every form of Plot3D and its map") {
    const Scratch scratch;
    for (const MultiblockGrid& grid : samples()) {
        for (const Plot3dForm form :
             {Plot3dForm::text, Plot3dForm::unformatted, Plot3dForm::stream}) {
            for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
                write_both(grid, scratch.path("grid.xyz"), form, order);
                check_same_grid(read_grid(scratch.path("grid.xyz")), grid);
            }
        }
    }
}

TEST_CASE("A block one node thick is a surface, whichever axis is flat") {
    const Scratch scratch;
    // Three by two points (i, j, 0), and what bounds the first of the two axes.
    const std::string points = "0 1 2 0 1 2  0 0 0 1 1 1  0 0 0 0 0 0\n";
    struct Flat {
        std::string size;
        std::string face;  ///< of the side where the first axis is least
    };
    for (const Flat& flat :
         {Flat{"3 2 1", "3 1 2 1 1"}, {"1 3 2", "5 1 2 1 1"}, {"3 1 2", "3 1 1 1 2"}}) {
        INFO(flat.size);
        put(scratch.path("flat.p3d"), "1\n" + flat.size + "\n" + points);
        put(scratch.path("flat.nmf"), "1\n1 " + flat.size + "\nINFLOW 1 " + flat.face + "\n");
        const MultiblockGrid grid = read_grid(scratch.path("flat.p3d"));
        CHECK(grid.cell_dimension == 2);
        REQUIRE(grid.zones[0].points.extent() == Extent{3, 2, 1});
        CHECK(grid.zones[0].points(2, 1) == Vec3{2, 1, 0});
        REQUIRE(grid.patches.size() == 1);
        CHECK(grid.patches[0].box == side_box(Side::imin, {3, 2, 1}));
    }
    put(scratch.path("line.p3d"), "1\n1 1 3\n0 1 2 0 0 0 0 0 0\n");
    CHECK_THAT(error_of(scratch.path("line.p3d")), Contains("3 nodes in a row"));
}

TEST_CASE("A patch of another type than its family's comes back from Plot3D and CGNS") {
    const Scratch scratch;
    MultiblockGrid grid = joined_pair(3, 3, rotations(3)[7]);
    grid.patches[1].type = "BCInflow";
    grid.patches[2].type = "UserDefined";
    write_both(grid, scratch.path("grid.xyz"), Plot3dForm::stream);
    check_same_grid(read_grid(scratch.path("grid.xyz")), grid);
    write_cgns(grid, scratch.path("grid.cgns"));
    check_same_grid(read_grid(scratch.path("grid.cgns")), grid);
    grid.patches[1].type = "wall";
    CHECK_THROWS_WITH(write_cgns(grid, scratch.path("grid.cgns")),
                      Contains("has the type 'wall', which CGNS does not know"));
}

TEST_CASE("The map holds every orientation: donor nodes are those of the interface") {
    const Scratch scratch;
    for (const int dimension : {2, 3}) {
        for (const Orientation& rotation : rotations(dimension)) {
            const MultiblockGrid grid = joined_pair(dimension, dimension, rotation);
            write_both(grid, scratch.path("grid.p3d"), Plot3dForm::text);
            const MultiblockGrid back = read_grid(scratch.path("grid.p3d"));
            REQUIRE(back.interfaces.size() == 1);
            const Interface& found = back.interfaces[0];
            for (int k = found.box.begin[2]; k <= found.box.end[2]; ++k) {
                for (int j = found.box.begin[1]; j <= found.box.end[1]; ++j) {
                    for (int i = found.box.begin[0]; i <= found.box.end[0]; ++i) {
                        const Node other = donor_node(found, {i, j, k});
                        CHECK(donor_node(grid.interfaces[0], {i, j, k}) == other);
                        CHECK(back.zones[1].points(other[0], other[1], other[2]) ==
                              back.zones[0].points(i, j, k));
                    }
                }
            }
        }
    }
}

// Two blocks that meet at imax of the first and jmax of the second, where j of the first (its
// primary direction) runs along i of the second (its secondary one), backwards.
TEST_CASE("The map tells periodic interfaces from joined ones") {
    const Scratch scratch;
    MultiblockGrid grid = joined_pair(3, 3, rotations(3)[5]);
    grid.interfaces[0].periodic = Periodicity{{0, 0.1, 0}, {0.3, 0, 0}, {0, 0, 1.0 / 3}};
    write_both(grid, scratch.path("grid.xyz"), Plot3dForm::unformatted);
    CHECK_THAT(contents(scratch.path("grid.nmf")), !Contains("ONE_TO_ONE"));
    check_same_grid(read_grid(scratch.path("grid.xyz")), grid);
}

TEST_CASE("A map is what the format's documentation says") {
    const Scratch scratch;
    MultiblockGrid grid;
    grid.zones = {{"one", PointField({3, 4, 5})}, {"two", PointField({4, 3, 5})}};
    grid.families = {{"wall", "BCWall"}};
    grid.interfaces = {
        {"seam", 0, {{2, 0, 0}, {2, 3, 4}}, 1, {{3, 2, 0}, {0, 2, 4}}, Orientation{{-2, -1, 3}}}};
    grid.patches = {{"floor", 0, {{0, 0, 0}, {2, 3, 0}}, 0},
                    {"left", 1, {{0, 0, 0}, {3, 0, 4}}, 0}};
    write_neutral_map(grid, scratch.path("map.nmf"));
    std::string plain;
    for (const char c : contents(scratch.path("map.nmf"))) {
        if (c != ' ' || plain.back() != ' ') plain += c;
    }
    CHECK_THAT(plain, Contains("\n 2\n") && Contains("\n 1 3 4 5\n") && Contains("\n 2 4 3 5\n"));
    CHECK_THAT(plain, Contains("\nONE_TO_ONE 1 4 1 4 1 5 2 6 1 5 4 1 TRUE\n"));
    CHECK_THAT(plain, Contains("\nwall 1 1 1 3 1 4\n"));
    CHECK_THAT(plain, Contains("\nwall 2 5 1 5 1 4\n"));
}

TEST_CASE("Single blocks, single precision, either byte order and blanking are found out") {
    const Scratch scratch;
    for (const bool records : {false, true}) {
        for (const bool big : {false, true}) {
            for (const bool blanking : {false, true}) {
                for (const int dimension : {2, 3}) {
                    const std::int32_t nodes = dimension == 3 ? 24 : 12;
                    std::string sizes;
                    for (const std::int32_t n : {4, 3, 2}) {
                        if (n > 2 || dimension == 3) add(sizes, n, big);
                    }
                    std::string block;
                    for (std::int32_t n = 0; n < dimension * nodes; ++n) {
                        add(block, 0.5F * static_cast<float>(n), big);
                    }
                    for (std::int32_t n = 0; blanking && n < nodes; ++n) {
                        add(block, std::int32_t{1}, big);
                    }
                    std::string file;
                    for (const std::string& record : {sizes, block}) {
                        const auto length = static_cast<std::int32_t>(record.size());
                        if (records) add(file, length, big);
                        file += record;
                        if (records) add(file, length, big);
                    }
                    put(scratch.path("one.x"), file);
                    const MultiblockGrid grid = read_grid(scratch.path("one.x"));
                    REQUIRE(grid.zones.size() == 1);
                    CHECK(grid.zones[0].name == "block1");
                    CHECK(grid.cell_dimension == dimension);
                    REQUIRE(grid.zones[0].points.extent() == Extent{4, 3, dimension == 3 ? 2 : 1});
                    CHECK(grid.zones[0].points.x(3, 2, 0) == 5.5);
                    CHECK(grid.zones[0].points.y(0, 0, 0) == 0.5 * nodes);
                }
            }
        }
    }
}

TEST_CASE("Records cut into pieces are put together") {
    const Scratch scratch;
    std::string file;
    for (const std::int32_t n : {12, 2, 2, 2, 12}) add(file, n);
    std::string numbers;
    for (int n = 0; n < 24; ++n) add(numbers, 0.25 * n);
    // More follows a negative opening count, more precedes a negative closing one.
    add(file, std::int32_t{-100});
    file += numbers.substr(0, 100);
    for (const std::int32_t n : {100, 92}) add(file, n);
    file += numbers.substr(100);
    add(file, std::int32_t{-92});
    put(scratch.path("cut.xyz"), file);
    const MultiblockGrid grid = read_grid(scratch.path("cut.xyz"));
    CHECK(grid.zones[0].points(1, 1, 1) == Vec3{1.75, 3.75, 5.75});
}

TEST_CASE("Text may repeat numbers and write exponents as Fortran does") {
    const Scratch scratch;
    put(scratch.path("f.fmt"), "2 2\n 0.0, 1.5D+00, 2*+2.5E-1\r\n 4*-1.0d0\n");
    const MultiblockGrid grid = read_grid(scratch.path("f.fmt"));
    CHECK(grid.cell_dimension == 2);
    CHECK(grid.physical_dimension == 2);
    CHECK(grid.zones[0].points.x(1, 0) == 1.5);
    CHECK(grid.zones[0].points.x(0, 1) == 0.25);
    CHECK(grid.zones[0].points.y(1, 1) == -1);
}

TEST_CASE("Numbers that are none come back as such") {
    const Scratch scratch;
    MultiblockGrid grid = joined_pair(3, 3, Orientation{});
    grid.zones[0].points.x(1, 1, 1) = std::numeric_limits<double>::quiet_NaN();
    grid.zones[1].points.z(0, 0, 0) = -std::numeric_limits<double>::infinity();
    for (const Plot3dForm form : {Plot3dForm::text, Plot3dForm::unformatted}) {
        write_both(grid, scratch.path("nan.xyz"), form);
        MultiblockGrid read = read_plot3d(scratch.path("nan.xyz"));
        read_neutral_map(scratch.path("nan.nmf"), read);
        check_same_grid(read, grid);
        CHECK_THAT(error_of(scratch.path("nan.xyz")),
                   Contains("node (2, 2, 2) of zone 'a' has a coordinate that is not a finite"));
    }
}

TEST_CASE("A planar grid may have the map of itself two nodes thick") {
    const Scratch scratch;
    put(scratch.path("two.p2d"), "2\n3 2 2 2\n0 1 2 0 1 2 0 0 0 1 1 1\n2 3 2 3 0 0 1 1\n");
    put(scratch.path("two.nmf"),
        "# a comment \\\n 2 \\\n \\\n 1 2 3 2 \\\n 2 2 2 2 \\\n"
        "'periodic'      1 3 1 3 1 2 \\\n'viscous_solid' 1 5 1 2 1 2\\\n"
        "'one-to-one'    1 6 1 2 1 2  2 5 1 2 1 2 false \\\n");
    const MultiblockGrid grid = read_grid(scratch.path("two.p2d"));
    REQUIRE(grid.patches.size() == 1);
    CHECK(grid.patches[0].box == IndexBox{{0, 0, 0}, {0, 1, 0}});
    CHECK(grid.families[0].name == "viscous_solid");
    CHECK(grid.families[0].type == "BCWallViscous");
    REQUIRE(grid.interfaces.size() == 1);
    CHECK(grid.interfaces[0].box == IndexBox{{2, 0, 0}, {2, 1, 0}});
    CHECK(grid.interfaces[0].donor_box == IndexBox{{0, 0, 0}, {0, 1, 0}});
    CHECK(grid.interfaces[0].orientation == Orientation{});
}

TEST_CASE("Damaged Plot3D files are refused with one message") {
    const Scratch scratch;
    write_plot3d(joined_pair(3, 3, rotations(3)[3]), scratch.path("whole.xyz"),
                 Plot3dForm::unformatted, ByteOrder::little);
    const std::string whole = contents(scratch.path("whole.xyz"));
    for (const std::size_t length : {std::size_t{0}, std::size_t{3}, std::size_t{12},
                                     std::size_t{60}, whole.size() / 2, whole.size() - 1}) {
        put(scratch.path("cut.xyz"), whole.substr(0, length));
        INFO(length);
        CHECK_THAT(error_of(scratch.path("cut.xyz")), StartsWith("cannot read '"));
    }
    // The number of blocks, the sizes, their marks and the one before the points.
    for (std::size_t place = 0; place < 48; ++place) {
        std::string damaged = whole;
        damaged[place] = static_cast<char>(damaged[place] ^ 0x5a);
        put(scratch.path("bad.xyz"), damaged);
        INFO(place);
        CHECK_THAT(error_of(scratch.path("bad.xyz")), StartsWith("cannot read '"));
    }
    put(scratch.path("text.p3d"), "2 2\n1 2 3 4\n1 2 3\n");
    CHECK_THAT(error_of(scratch.path("text.p3d")), Contains("does not agree with the sizes"));
    put(scratch.path("text.p3d"), "2 2\n1 2 3 4\n1 2 ** 4\n");
    CHECK_THAT(error_of(scratch.path("text.p3d")), Contains("line 3: '**' is no number"));
    put(scratch.path("text.p3d"), "1 1 1 999999999999*0\n");
    CHECK_THAT(error_of(scratch.path("text.p3d")), Contains("is no number"));
    put(scratch.path("text.p3d"), "2 2 2 0 0 0 0 0 1\n");
    CHECK_THAT(error_of(scratch.path("text.p3d")), StartsWith("cannot read"));
    CHECK_THAT(error_of(scratch.path("none.p3d")), Contains("no such file"));
    CHECK_THAT(error_of(scratch.folder()), StartsWith("cannot read"));
    put(scratch.path("holes.fmt"), "2 2  0 1 0 1  0 0 1 1  1 1 0 1\n");
    CHECK_THAT(error_of(scratch.path("holes.fmt")), Contains("blanked out"));
}

TEST_CASE("Maps that are wrong are refused with their line") {
    const Scratch scratch;
    put(scratch.path("g.fmt"), "2 2  0 1 0 1  0 0 1 1\n");
    const auto refused = [&](const std::string& map) {
        put(scratch.path("g.nmf"), map);
        return error_of(scratch.path("g.fmt"));
    };
    CHECK_THAT(refused(""), Contains("empty"));
    CHECK_THAT(refused("2\n"), Contains("2 blocks, and there are 1"));
    CHECK_THAT(refused("1\n1 2 3 1\n"), Contains("line 2") && Contains("not those of the grid"));
    const std::string head = "1\n1 2 2 1\n";
    CHECK(error_of(scratch.path("g.fmt")) != "no error");
    CHECK(refused(head) == "no error");
    CHECK_THAT(refused(head + "wall 2 3 1 2 1 1\n"), Contains("line 3: there is no block 2"));
    CHECK_THAT(refused(head + "wall 1 7 1 2 1 1\n"), Contains("no face 7"));
    CHECK_THAT(refused(head + "wall 1 3 1 3 1 1\n"), Contains("node 3 lies outside"));
    CHECK_THAT(refused(head + "wall 1 3 1 2 1\n"), Contains("lacking"));
    CHECK_THAT(refused(head + "wall 1 3 1 2 1 1 9\n"), Contains("six numbers"));
    CHECK_THAT(refused(head + "wall x 3 1 2 1 1\n"), Contains("'x' is not a whole number"));
    CHECK_THAT(refused(head + "ONE_TO_ONE 1 3 1 2 1 1 1 4 1 2 1 1\n"), Contains("TRUE or FALSE"));
    CHECK_THAT(refused(head + "ONE_TO_ONE 1 3 1 2 1 1 1 4 1 1 1 1 FALSE\n"),
               Contains("different numbers of nodes"));
    CHECK_THAT(refused(head + "ONE_TO_ONE 1 3 1 1 1 1 1 4 1 1 1 1 TRUE\n"), Contains("Swap"));
    CHECK_THAT(refused(head + "PATCHED 1 3 1 2 1 1 1 4 1 2 1 1\n"), Contains("not one-to-one"));
}

TEST_CASE("The format of a grid is known by its name, and CGNS by its bytes too") {
    const Scratch scratch;
    const MultiblockGrid grid = c_grid();
    write_cgns(grid, scratch.path("c.cgns"));
    std::filesystem::copy(scratch.path("c.cgns"), scratch.path("c.hdf"));
    check_same_points(read_grid(scratch.path("c.hdf")), grid);
    put(scratch.path("c.txt"), "2 2 0 0 0 0 1 1 1 1\n");
    CHECK_THAT(error_of(scratch.path("c.txt")), Contains("not known by its ending '.txt'"));
    put(scratch.path("c.vtm"), "<VTKFile/>");
    CHECK_THAT(error_of(scratch.path("c.vtm")), Contains("writes this format"));
    CHECK(read_grid(scratch.path("c.txt"), GridFormat::plot3d).zones.size() == 1);
}
