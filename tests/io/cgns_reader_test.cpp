// SPDX-License-Identifier: Apache-2.0
// Files of other programs, and files that are none.
#include <cgnslib.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "core/interface_sides.h"
#include "io/cgns.h"
#include "io/cgns_samples.h"
#include "io/scratch.h"

using namespace hexweave;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

namespace {

/// A file written by libcgns as another program would: one base, then what `fill` adds.
template <class Fill>
std::filesystem::path other_program(const Scratch& scratch, int file_type, int cell_dimension,
                                    Fill&& fill) {
    std::filesystem::path path = scratch.path("other.cgns");
    int file = 0;
    int base = 0;
    cg_set_file_type(file_type);
    REQUIRE(cg_open(path.c_str(), CG_MODE_WRITE, &file) == CG_OK);
    REQUIRE(cg_base_write(file, "Flow", cell_dimension, 3, &base) == CG_OK);
    fill(file, base);
    REQUIRE(cg_close(file) == CG_OK);
    return path;
}

/// A box of 3 x 4 x 2 nodes with coordinates in single precision, in inches unless said.
int single_precision_box(int file, int base, const char* name, LengthUnits_t length = Inch) {
    const cgsize_t size[9] = {3, 4, 2, 2, 3, 1, 0, 0, 0};
    int zone = 0;
    int number = 0;
    REQUIRE(cg_zone_write(file, base, name, size, Structured, &zone) == CG_OK);
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> values;
        for (int k = 0; k < 2; ++k) {
            for (int j = 0; j < 4; ++j) {
                for (int i = 0; i < 3; ++i) {
                    values.push_back(0.5F * static_cast<float>(axis == 0 ? i : axis == 1 ? j : k));
                }
            }
        }
        const char* names[] = {"CoordinateX", "CoordinateY", "CoordinateZ"};
        REQUIRE(cg_coord_write(file, base, zone, RealSingle, names[axis], values.data(), &number) ==
                CG_OK);
        if (length == LengthUnitsNull) continue;
        cg_goto(file, base, "Zone_t", zone, "GridCoordinates_t", 1, "DataArray_t", number, "end");
        cg_units_write(MassUnitsNull, length, TimeUnitsNull, TemperatureUnitsNull, AngleUnitsNull);
    }
    return zone;
}

void require_box(const MultiblockGrid& grid) {
    REQUIRE(grid.zones.size() == 1);
    CHECK(grid.zones[0].name == "box");
    REQUIRE(grid.zones[0].points.extent() == Extent{3, 4, 2});
    CHECK(grid.zones[0].points(2, 3, 1) == Vec3{1, 1.5, 0.5});
    CHECK(grid.units == "in");
}

}  // namespace

TEST_CASE("Single precision, units on the coordinates and literal types are read") {
    const Scratch scratch;
    for (const int type : {CG_FILE_HDF5, CG_FILE_ADF}) {
        const auto path = other_program(scratch, type, 3, [](int file, int base) {
            const int zone = single_precision_box(file, base, "box");
            int number = 0;
            const cgsize_t nodes[6] = {1, 1, 1, 3, 4, 1};
            const cgsize_t faces[6] = {3, 1, 1, 3, 3, 1};
            cg_boco_write(file, base, zone, "bottom", BCWall, PointRange, 2, nodes, &number);
            cg_boco_write(file, base, zone, "end", BCInflow, PointRange, 2, faces, &number);
            cg_boco_gridlocation_write(file, base, zone, number, IFaceCenter);
            std::vector<cgsize_t> list;
            for (int i = 1; i <= 3; ++i) {
                for (int k = 1; k <= 2; ++k) list.insert(list.end(), {i, 1, k});
            }
            cg_boco_write(file, base, zone, "list", BCWall, PointList, 6, list.data(), &number);
            cg_goto(file, base, "Zone_t", zone, "ZoneBC_t", 1, "BC_t", number, "end");
            cg_famname_write("hull");
        });
        const MultiblockGrid grid = read_cgns(path);
        require_box(grid);
        REQUIRE(grid.patches.size() == 3);
        CHECK(grid.patches[0].box == side_box(Side::kmin, {3, 4, 2}));
        CHECK(grid.patches[1].box == side_box(Side::imax, {3, 4, 2}));
        CHECK(grid.patches[2].box == side_box(Side::jmin, {3, 4, 2}));
        REQUIRE(grid.families.size() == 3);
        CHECK(grid.families[0].name == "BCWall");
        CHECK(grid.families[0].type == "BCWall");
        CHECK(grid.families[1].name == "BCInflow");
        CHECK(grid.families[2].name == "hull");
        CHECK(grid.families[2].type == "BCWall");
    }
}

TEST_CASE("A boundary's own type goes before its family's") {
    const Scratch scratch;
    struct Written {
        BCType_t type;
        const char* family;
        std::string own;  ///< what is to be kept of it
    };
    const std::vector<Written> conditions{
        {FamilySpecified, "declared", ""},  {BCWall, "declared", ""},
        {BCInflow, "declared", "BCInflow"}, {BCTypeNull, "declared", ""},
        {BCTypeUserDefined, "overset", ""}, {BCWall, "bare", ""},
        {BCOutflow, "bare", "BCOutflow"},   {FamilySpecified, "bare", "UserDefined"}};
    const auto path = other_program(scratch, CG_FILE_HDF5, 3, [&](int file, int base) {
        int family = 0;
        int number = 0;
        cg_family_write(file, base, "declared", &family);
        cg_fambc_write(file, base, family, "FamBC", BCWall, &number);
        cg_family_write(file, base, "overset", &family);
        cg_fambc_write(file, base, family, "FamBC", BCTypeUserDefined, &number);
        cg_goto(file, base, "Family_t", family, "end");
        cg_user_data_write("BCOverset");
        cg_family_write(file, base, "bare", &family);
        const int zone = single_precision_box(file, base, "box");
        for (std::size_t n = 0; n < conditions.size(); ++n) {
            const cgsize_t nodes[6] = {1, 1, 1, 3, 4, 1};
            cg_boco_write(file, base, zone, ("patch" + std::to_string(n)).c_str(),
                          conditions[n].type, PointRange, 2, nodes, &number);
            cg_goto(file, base, "Zone_t", zone, "ZoneBC_t", 1, "BC_t", number, "end");
            cg_famname_write(conditions[n].family);
        }
    });
    const MultiblockGrid grid = read_cgns(path);
    REQUIRE(grid.patches.size() == conditions.size());
    for (std::size_t n = 0; n < conditions.size(); ++n) {
        INFO(n);
        CHECK(grid.patches[n].type == conditions[n].own);
    }
    REQUIRE(grid.families.size() == 3);
    CHECK_FALSE(grid.families[0].undeclared);
    CHECK(grid.families[2].undeclared);
    CHECK(grid.families[2].type == "BCWall");

    // What is read is written, and read again.
    write_cgns(grid, scratch.path("again.cgns"));
    const MultiblockGrid again = read_cgns(scratch.path("again.cgns"));
    for (std::size_t n = 0; n < conditions.size(); ++n) {
        CHECK(type_of(again.patches[n], again.families) == type_of(grid.patches[n], grid.families));
    }
}

namespace {

/// Where units may be said, from the outermost node to the innermost.
enum class Place { base, zone, coordinates, array };

void write_units(int file, int base, int zone, Place place, LengthUnits_t length,
                 AngleUnits_t angle = AngleUnitsNull) {
    const auto write = [&] {
        REQUIRE(cg_units_write(MassUnitsNull, length, TimeUnitsNull, TemperatureUnitsNull, angle) ==
                CG_OK);
    };
    if (place == Place::base) {
        REQUIRE(cg_goto(file, base, "end") == CG_OK);
        write();
    } else if (place == Place::zone) {
        REQUIRE(cg_goto(file, base, "Zone_t", zone, "end") == CG_OK);
        write();
    } else if (place == Place::coordinates) {
        REQUIRE(cg_goto(file, base, "Zone_t", zone, "GridCoordinates_t", 1, "end") == CG_OK);
        write();
    } else {
        for (int number = 1; number <= 3; ++number) {
            REQUIRE(cg_goto(file, base, "Zone_t", zone, "GridCoordinates_t", 1, "DataArray_t",
                            number, "end") == CG_OK);
            write();
        }
    }
}

/// A periodic interface between imin and imax of the box, from the given side, without units.
int periodic_interface(int file, int base, int zone, bool forth, std::array<float, 3> angle,
                       std::array<float, 3> translation) {
    const cgsize_t low[6] = {1, 1, 1, 1, 4, 2};
    const cgsize_t high[6] = {3, 1, 1, 3, 4, 2};
    const int transform[3] = {1, 2, 3};
    const float center[3] = {0, 1, 0};
    int number = 0;
    REQUIRE(cg_1to1_write(file, base, zone, forth ? "forth" : "back", "box", forth ? low : high,
                          forth ? high : low, transform, &number) == CG_OK);
    REQUIRE(cg_1to1_periodic_write(file, base, zone, number, center, angle.data(),
                                   translation.data()) == CG_OK);
    return number;
}

}  // namespace

TEST_CASE("The innermost units of the coordinates hold") {
    const Scratch scratch;
    const auto units = [&](std::vector<std::pair<Place, LengthUnits_t>> said) {
        const auto path = other_program(scratch, CG_FILE_HDF5, 3, [&](int file, int base) {
            const int zone = single_precision_box(file, base, "box", LengthUnitsNull);
            for (const auto& [place, length] : said) write_units(file, base, zone, place, length);
        });
        return read_cgns(path).units;
    };
    CHECK(units({}).empty());
    CHECK(units({{Place::base, Meter}}) == "m");
    CHECK(units({{Place::base, Meter}, {Place::array, Millimeter}}) == "mm");
    CHECK(units({{Place::base, Meter}, {Place::coordinates, Foot}}) == "ft");
    CHECK(units({{Place::base, Meter}, {Place::zone, Centimeter}}) == "cm");
    CHECK(units({{Place::zone, Foot}, {Place::coordinates, Inch}, {Place::array, Meter}}) == "m");
    CHECK(units({{Place::base, Meter}, {Place::array, LengthUnitsNull}}) == "m");

    const auto mixed = other_program(scratch, CG_FILE_HDF5, 3, [](int file, int base) {
        write_units(file, base, 0, Place::base, Meter);
        single_precision_box(file, base, "a", LengthUnitsNull);
        single_precision_box(file, base, "b", Millimeter);
    });
    CHECK_THROWS_WITH(
        read_cgns(mixed),
        EndsWith("CoordinateX of zone 'b' is in mm and others are in m; hexweave reads grids in "
                 "one unit"));
}

TEST_CASE("A periodicity is read in radians and in the unit of the grid") {
    const Scratch scratch;
    const auto path = other_program(scratch, CG_FILE_HDF5, 3, [](int file, int base) {
        // Lengths of the base in metres, those of the points in millimetres.
        write_units(file, base, 0, Place::base, Meter, Degree);
        const int zone = single_precision_box(file, base, "box", Millimeter);
        const int number = periodic_interface(file, base, zone, true, {90, 0, 0}, {0.001F, 0, 0});
        REQUIRE(cg_goto(file, base, "Zone_t", zone, "ZoneGridConnectivity_t", 1,
                        "GridConnectivity1to1_t", number, "GridConnectivityProperty_t", 1,
                        "Periodic_t", 1, "RotationCenter", 0, "end") == CG_OK);
        cg_units_write(MassUnitsNull, Centimeter, TimeUnitsNull, TemperatureUnitsNull,
                       AngleUnitsNull);
    });
    const MultiblockGrid grid = read_cgns(path);
    REQUIRE(grid.interfaces.size() == 1);
    const Periodicity& periodic = *grid.interfaces[0].periodic;
    CHECK(periodic.angle.x == Approx(std::acos(0.0)).epsilon(1e-7));
    CHECK(periodic.translation.x == Approx(1).epsilon(1e-7));
    CHECK(periodic.center.y == Approx(10).epsilon(1e-7));
}

TEST_CASE("A periodic grid that was read is written as it was") {
    const Scratch scratch;
    MultiblockGrid grid = joined_pair(3, 3, rotations(3)[7]);
    Interface& seam = grid.interfaces[0];
    for (const double angle : {0.5, -0.5}) {
        for (int side = 0; side < 2; ++side) {
            seam = other_side(seam);
            seam.periodic = Periodicity{{}, angle * Vec3{1, 0, 0}, angle * Vec3{}};
            write_cgns(grid, scratch.path("once.cgns"));
            write_cgns(read_cgns(scratch.path("once.cgns")), scratch.path("twice.cgns"));
            CHECK(contents(scratch.path("once.cgns")) == contents(scratch.path("twice.cgns")));
        }
    }
}

TEST_CASE("Two ends of an interface that contradict each other are refused") {
    const Scratch scratch;
    const auto read = [&](std::array<float, 3> angle, std::array<float, 3> translation) {
        return read_cgns(other_program(scratch, CG_FILE_HDF5, 3, [&](int file, int base) {
            const int zone = single_precision_box(file, base, "box", Meter);
            periodic_interface(file, base, zone, true, {}, {1, 0, 0});
            periodic_interface(file, base, zone, false, angle, translation);
        }));
    };
    CHECK(read({}, {-1, 0, 0}).interfaces.size() == 1);
    CHECK(read({1e-12F, 0, 0}, {-1 - 1e-7F, 0, 0}).interfaces.size() == 1);
    CHECK_THROWS_WITH(read({}, {1, 0, 0}),
                      Contains("'back' of zone 'box' is periodic by rotation (0, 0, 0) about (0, "
                               "1, 0) and translation (1, 0, 0); the one is not the way back"));
    CHECK_THROWS_AS(read({}, {-1.001F, 0, 0}), UsageError);
    CHECK_THROWS_AS(read({0.01F, 0, 0}, {-1, 0, 0}), UsageError);
}

TEST_CASE("An interface that is written on one side only is read once") {
    const Scratch scratch;
    const auto path = other_program(scratch, CG_FILE_HDF5, 3, [](int file, int base) {
        single_precision_box(file, base, "a");
        const int zone = single_precision_box(file, base, "b");
        int number = 0;
        const cgsize_t own[6] = {3, 4, 2, 3, 1, 1};
        const cgsize_t donor[6] = {1, 4, 2, 1, 1, 1};
        const int transform[3] = {1, 2, 3};
        REQUIRE(cg_1to1_write(file, base, zone, "seam", "a", own, donor, transform, &number) ==
                CG_OK);
    });
    const MultiblockGrid grid = read_cgns(path);
    REQUIRE(grid.interfaces.size() == 1);
    CHECK(grid.interfaces[0].zone == 1);
    CHECK(grid.interfaces[0].donor == 0);
    CHECK(grid.interfaces[0].box == side_box(Side::imax, {3, 4, 2}));
    CHECK(grid.interfaces[0].donor_box == side_box(Side::imin, {3, 4, 2}));
}

TEST_CASE("Seen from the donor and back again an interface is itself") {
    for (const Orientation& o : rotations(3)) {
        const Interface seam = joined_pair(3, 3, o).interfaces[0];
        const Interface other = other_side(seam);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            CHECK(other.box.begin[axis] <= other.box.end[axis]);
        }
        const Interface back = other_side(other);
        CHECK(back.zone == seam.zone);
        CHECK(back.box == seam.box);
        CHECK(back.donor_box == seam.donor_box);
        CHECK(back.orientation == seam.orientation);
    }
}

TEST_CASE("What cannot be read is said plainly") {
    const Scratch scratch;
    const auto path = [&](const std::string& name) { return scratch.path(name); };
    put(path("text.cgns"), "not a grid\n");
    put(path("empty.cgns"), "");
    CHECK_THROWS_AS(read_cgns(path("none.cgns")), UsageError);
    CHECK_THROWS_WITH(read_cgns(path("none.cgns")), EndsWith("none.cgns': no such file"));
    CHECK_THROWS_WITH(read_cgns(scratch.folder()), EndsWith("it is a folder"));
    CHECK_THROWS_WITH(read_cgns("/dev/null"), EndsWith("it is not a regular file"));
    CHECK_THROWS_WITH(read_cgns(path("text.cgns")), EndsWith("it is not a CGNS file"));
    CHECK_THROWS_WITH(read_cgns(path("empty.cgns")), EndsWith("it is not a CGNS file"));
    CHECK_THROWS_WITH(read_cgns(path("text.cgns") / "x.cgns"), EndsWith("not a directory"));
}

TEST_CASE("A CGNS file that holds no structured grid is refused") {
    const Scratch scratch;
    const auto nothing = [](int, int) {};
    CHECK_THROWS_WITH(read_cgns(other_program(scratch, CG_FILE_HDF5, 3, nothing)),
                      EndsWith("it holds no zones"));
    CHECK_THROWS_WITH(read_cgns(other_program(scratch, CG_FILE_ADF, 1, nothing)),
                      Contains("1 dimensions in a space of 3"));
    const auto second_base = [](int file, int) {
        int base = 0;
        cg_base_write(file, "Other", 3, 3, &base);
    };
    CHECK_THROWS_WITH(read_cgns(other_program(scratch, CG_FILE_HDF5, 3, second_base)),
                      Contains("it holds 2 bases"));
    const auto unstructured = [](int file, int base) {
        const cgsize_t size[3] = {8, 1, 0};
        int zone = 0;
        cg_zone_write(file, base, "tets", size, Unstructured, &zone);
    };
    CHECK_THROWS_WITH(
        read_cgns(other_program(scratch, CG_FILE_HDF5, 3, unstructured)),
        EndsWith("zone 'tets' is unstructured; hexweave reads structured zones only"));
    const auto bare = [](int file, int base) {
        const cgsize_t size[9] = {3, 4, 2, 2, 3, 1, 0, 0, 0};
        int zone = 0;
        cg_zone_write(file, base, "bare", size, Structured, &zone);
    };
    CHECK_THROWS_WITH(read_cgns(other_program(scratch, CG_FILE_HDF5, 3, bare)),
                      EndsWith("zone 'bare' has no CoordinateX"));
    const auto huge = [](int file, int base) {
        const cgsize_t size[9] = {40000, 40000, 40000, 39999, 39999, 39999, 0, 0, 0};
        int zone = 0;
        cg_zone_write(file, base, "huge", size, Structured, &zone);
    };
    // Refused before anything is reserved for it.
    CHECK_THROWS_WITH(read_cgns(other_program(scratch, CG_FILE_HDF5, 3, huge)),
                      EndsWith("zone 'huge' has no CoordinateX"));
}

TEST_CASE("Boundary conditions and interfaces that fit nothing are refused") {
    const Scratch scratch;
    const auto with = [&](auto&& add) {
        return other_program(scratch, CG_FILE_HDF5, 3, [&](int file, int base) {
            add(file, base, single_precision_box(file, base, "box"));
        });
    };
    int number = 0;
    const auto outside = [&](int file, int base, int zone) {
        const cgsize_t nodes[6] = {1, 1, 1, 3, 5, 1};
        cg_boco_write(file, base, zone, "wide", BCWall, PointRange, 2, nodes, &number);
    };
    CHECK_THROWS_WITH(read_cgns(with(outside)),
                      EndsWith("boundary condition 'wide' of zone 'box' lies outside the zone"));
    const auto scattered = [&](int file, int base, int zone) {
        const cgsize_t nodes[6] = {1, 1, 1, 3, 3, 1};
        cg_boco_write(file, base, zone, "dots", BCWall, PointList, 2, nodes, &number);
    };
    CHECK_THROWS_WITH(read_cgns(with(scattered)), EndsWith("is not a rectangle of nodes or faces"));
    const auto nameless = [&](int file, int base, int zone) {
        const cgsize_t nodes[6] = {1, 1, 1, 3, 4, 1};
        cg_boco_write(file, base, zone, "orphan", FamilySpecified, PointRange, 2, nodes, &number);
    };
    CHECK_THROWS_WITH(read_cgns(with(nameless)), EndsWith("to a family and names none"));
    const auto stray = [&](int file, int base, int zone) {
        const cgsize_t nodes[6] = {1, 1, 1, 1, 4, 2};
        const int transform[3] = {1, 2, 3};
        cg_1to1_write(file, base, zone, "seam", "moon", nodes, nodes, transform, &number);
    };
    CHECK_THROWS_WITH(read_cgns(with(stray)),
                      EndsWith("leads to 'moon', which is not in the file"));
}

TEST_CASE("No damaged file ends the program") {
    const Scratch scratch;
    const std::filesystem::path path = scratch.path("damaged.cgns");
    write_cgns(joined_pair(3, 3, rotations(3)[5]), scratch.path("whole.cgns"));
    const std::string whole = contents(scratch.path("whole.cgns"));
    std::uint32_t state = 1;
    const auto draw = [&](std::size_t below) {
        state = state * 1664525U + 1013904223U;
        return static_cast<std::size_t>(state >> 8U) % below;
    };
    int refused = 0;
    for (int attempt = 0; attempt < 40; ++attempt) {
        std::string text = whole;
        if (attempt % 4 == 0) {
            text.resize(draw(text.size()));
        } else {
            for (int n = 0; n < attempt; ++n)
                text[draw(text.size())] = static_cast<char>(draw(256));
        }
        put(path, text);
        try {
            read_cgns(path);
        } catch (const UsageError& error) {
            ++refused;
            CHECK_THAT(error.what(), Contains("damaged.cgns"));
        }
    }
    CHECK(refused > 10);
}
