// SPDX-License-Identifier: Apache-2.0
// `hexweave compare` and the golden grids, as users meet them.
#include <cgnslib.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/multiblock.h"
#include "io/cgns.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using Json = nlohmann::json;

namespace {

const std::string goldens = std::string(HEXWEAVE_SOURCE_DIR) + "/tests/goldens/";

struct GoldenCase {
    std::string name;
    std::string overrides;
};

/// The lines of tests/goldens/cases.
std::vector<GoldenCase> golden_cases() {
    std::vector<GoldenCase> cases;
    std::ifstream stream(goldens + "cases");
    for (std::string line; std::getline(stream, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        GoldenCase c{"", " --set tolerance=1e-7"};
        words >> c.name;
        for (std::string word; words >> word;) c.overrides += " --set " + word;
        cases.push_back(c);
    }
    return cases;
}

/// A golden grid, changed by `change`, as a file of the scratch folder.
template <class Change>
std::string perturbed(const Scratch& scratch, const std::string& name, Change&& change) {
    MultiblockGrid grid = read_cgns(goldens + name + ".cgns");
    change(grid);
    write_cgns(grid, scratch.path() / "new.cgns");
    return "compare new.cgns " + goldens + name + ".cgns";
}

int lines(const std::string& text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

/// A box of 3 x 4 x 5 nodes in a file that libcgns wrote, with more in it where `more` says.
template <class More>
void write_box(const std::filesystem::path& path, More&& more, int file_type = CG_FILE_HDF5) {
    int file = 0;
    int base = 0;
    int zone = 0;
    int number = 0;
    cg_set_file_type(file_type);
    REQUIRE(cg_open(path.c_str(), CG_MODE_WRITE, &file) == CG_OK);
    REQUIRE(cg_base_write(file, "Base", 3, 3, &base) == CG_OK);
    const cgsize_t size[9] = {3, 4, 5, 2, 3, 4, 0, 0, 0};
    REQUIRE(cg_zone_write(file, base, "box", size, Structured, &zone) == CG_OK);
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (int n = 0; n < 60; ++n) {
            values.push_back(axis == 0 ? n % 3 : axis == 1 ? n / 3 % 4 : n / 12);
        }
        const char* names[] = {"CoordinateX", "CoordinateY", "CoordinateZ"};
        REQUIRE(cg_coord_write(file, base, zone, RealDouble, names[axis], values.data(), &number) ==
                CG_OK);
    }
    more(file, base, zone);
    REQUIRE(cg_close(file) == CG_OK);
}

void leave_alone(int, int, int) {}

/// Runs a comparison that cannot be made: one message, exit code 2.
void check_refused(const Scratch& scratch, const std::string& arguments,
                   const std::string& message) {
    const Finished run = scratch.hexweave("compare " + arguments);
    INFO(arguments << "\n" << run.out << run.err);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK(lines(run.err) == 1);
    CHECK_THAT(run.err, StartsWith("hexweave: error: "));
    CHECK_THAT(run.err, Contains(message));
}

}  // namespace

TEST_CASE("every shipped case makes its golden grid") {
    std::set<std::string> names;
    for (const GoldenCase& c : golden_cases()) {
        names.insert(c.name);
        const bool needs_cad = slurp(shipped(c.name + ".yaml")).find("{cad:") != std::string::npos;
        if (needs_cad && HEXWEAVE_HAS_CAD == 0) continue;
        DYNAMIC_SECTION(c.name) {
            const Scratch scratch;
            const Finished run = scratch.hexweave("run --quiet " + shipped(c.name + ".yaml") +
                                                  c.overrides + " -o new.cgns");
            INFO(run.out << run.err);
            REQUIRE(run.exit_code == 0);
            const Finished compare =
                scratch.hexweave("compare new.cgns " + goldens + c.name + ".cgns");
            INFO(compare.out << compare.err);
            CHECK(compare.exit_code == 0);
            CHECK_THAT(compare.out, Contains("same: "));
        }
    }
    for (const auto& entry : std::filesystem::directory_iterator(goldens)) {
        if (entry.path().extension() == ".cgns") CHECK(names.count(entry.path().stem()) == 1);
    }
}

TEST_CASE("a point moved by a thousandth of a cell fails") {
    const Scratch scratch;
    const std::string compare = perturbed(scratch, "pipe", [](MultiblockGrid& grid) {
        PointField& points = grid.zones[0].points;
        const Vec3 p = points(2, 3, 4);
        double cell = distance(p, points(1, 3, 4));
        for (const Vec3& q : {points(3, 3, 4), points(2, 2, 4), points(2, 4, 4), points(2, 3, 3),
                              points(2, 3, 5)}) {
            cell = std::min(cell, distance(p, q));
        }
        points.set(2, 3, 4, p + Vec3{0, 0, 1e-3 * cell});
    });
    const Finished run = scratch.hexweave(compare + " --json -");
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.err, Contains("different: 1 point of "));
    const Json json = Json::parse(run.out);
    CHECK(json["exit_code"] == 1);
    CHECK(json["comparison"]["same"] == false);
    CHECK(json["comparison"]["beyond"] == 1);
    CHECK(json["comparison"]["in_cells"]["size"].get<double>() == Approx(1e-3));
    CHECK(json["comparison"]["zones"][0]["in_cells"]["node"] == Json({3, 4, 5}));
    CHECK(scratch.hexweave(compare + " --tolerance 2e-3").exit_code == 0);
}

TEST_CASE("an interface range off by one fails") {
    const Scratch scratch;
    const std::string compare = perturbed(scratch, "pipe", [](MultiblockGrid& grid) {
        Interface& f = grid.interfaces[0];
        std::size_t axis = 0;
        while (f.box.begin[axis] == f.box.end[axis]) ++axis;
        const int across = f.orientation.axes[axis];
        --f.box.end[axis];
        f.donor_box.end[static_cast<std::size_t>(std::abs(across) - 1)] -= across > 0 ? 1 : -1;
    });
    const Finished run = scratch.hexweave(compare);
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.out, Contains("different: 1 interface\n"));
}

TEST_CASE("a boundary of another type fails, whatever its family says") {
    const Scratch scratch;
    const auto write = [&](const char* name, BCType_t declared, BCType_t second) {
        write_box(scratch.path() / name, [&](int file, int base, int zone) {
            int number = 0;
            cg_family_write(file, base, "shell", &number);
            if (declared != BCTypeNull) {
                int condition = 0;
                cg_fambc_write(file, base, number, "FamBC", declared, &condition);
            }
            const cgsize_t ranges[2][6] = {{1, 1, 1, 3, 4, 1}, {1, 1, 5, 3, 4, 5}};
            for (int n = 0; n < 2; ++n) {
                cg_boco_write(file, base, zone, n == 0 ? "low" : "high", n == 0 ? BCWall : second,
                              PointRange, 2, ranges[n], &number);
                cg_goto(file, base, "Zone_t", zone, "ZoneBC_t", 1, "BC_t", number, "end");
                cg_famname_write("shell");
            }
        });
    };
    for (const BCType_t declared : {BCTypeNull, BCWall}) {
        write("golden.cgns", declared, BCWall);
        write("new.cgns", declared, BCInflow);
        const Finished run = scratch.hexweave("compare new.cgns golden.cgns");
        INFO(run.out << run.err);
        CHECK(run.exit_code == 1);
        CHECK_THAT(run.out, Contains("boundary: zone 'box', nodes [1, 1, 5] to [3, 4, 5]: boundary "
                                     "'shell' is of type BCInflow, golden BCWall\n"
                                     "different: 1 boundary\n"));
        CHECK(scratch.hexweave("compare new.cgns new.cgns").exit_code == 0);
    }
}

TEST_CASE("an interface whose two ends contradict each other is told by every command") {
    const Scratch scratch;
    const auto write = [&](const char* name, std::array<float, 3> back) {
        write_box(scratch.path() / name, [&](int file, int base, int zone) {
            const cgsize_t low[6] = {1, 1, 1, 1, 4, 5};
            const cgsize_t high[6] = {3, 1, 1, 3, 4, 5};
            const int transform[3] = {1, 2, 3};
            const float none[3] = {};
            const float forth[3] = {2, 0, 0};
            int number = 0;
            cg_1to1_write(file, base, zone, "first", "box", low, high, transform, &number);
            cg_1to1_periodic_write(file, base, zone, number, none, none, forth);
            cg_1to1_write(file, base, zone, "second", "box", high, low, transform, &number);
            cg_1to1_periodic_write(file, base, zone, number, none, none, back.data());
        });
    };
    write("golden.cgns", {-2, 0, 0});
    write("new.cgns", {-2.02F, 0, 0});
    CHECK(scratch.hexweave("compare golden.cgns golden.cgns").exit_code == 0);
    CHECK(scratch.hexweave("quality golden.cgns").exit_code == 0);
    const std::string fault = "the two ends of an interface contradict each other: 'first' of zone";
    const Finished run = scratch.hexweave("compare new.cgns golden.cgns");
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.out, Contains("interface: " + fault));
    check_refused(scratch, "golden.cgns new.cgns", "in the golden grid " + fault);
    for (const std::string command : {"quality new.cgns", "convert new.cgns new.xyz"}) {
        const Finished refused = scratch.hexweave(command);
        CHECK(refused.exit_code == 2);
        CHECK_THAT(refused.err, Contains("cannot read 'new.cgns': " + fault));
    }
}

TEST_CASE("units are those of the innermost node") {
    const Scratch scratch;
    const auto write = [&](const char* name, LengthUnits_t inner) {
        write_box(scratch.path() / name, [&](int file, int base, int zone) {
            cg_goto(file, base, "end");
            cg_units_write(Kilogram, Meter, Second, Kelvin, Radian);
            cg_goto(file, base, "Zone_t", zone, "GridCoordinates_t", 1, "end");
            cg_units_write(Kilogram, inner, Second, Kelvin, Radian);
        });
    };
    write("m.cgns", Meter);
    write("mm.cgns", Millimeter);
    const Finished run = scratch.hexweave("compare mm.cgns m.cgns");
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.out, Contains("units: the length unit is mm, golden m\ndifferent: units\n"));
    CHECK(scratch.hexweave("convert mm.cgns case.foam").exit_code == 0);
    CHECK_THAT(slurp((scratch.path() / "constant/polyMesh/points").string()),
               Contains("(0.002 0.003 0.004)"));
}

TEST_CASE("a renamed family fails") {
    const Scratch scratch;
    const std::string compare =
        perturbed(scratch, "pipe", [](MultiblockGrid& grid) { grid.families[0].name = "renamed"; });
    const Finished run = scratch.hexweave(compare);
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.out, Contains("family 'renamed'"));
    CHECK_THAT(run.out, Contains("different: 2 families, "));
}

TEST_CASE("a number that is none fails, and a golden grid with one is refused") {
    const Scratch scratch;
    const std::string compare = perturbed(scratch, "scherk", [](MultiblockGrid& grid) {
        grid.zones[0].points.y(4, 7) = std::numeric_limits<double>::quiet_NaN();
    });
    const Finished run = scratch.hexweave(compare);
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.out, Contains("different: 1 point of "));
    CHECK_THAT(run.out, EndsWith(" beyond 0.0001 of a cell, 1 no finite number\n"));
    check_refused(scratch, goldens + "scherk.cgns new.cgns", "node (5, 8, 1) of zone");
    check_refused(scratch, "new.cgns new.cgns", "not a finite number");
}

TEST_CASE("zones that were renamed are found by their shape") {
    const Scratch scratch;
    const std::string compare = perturbed(scratch, "swept_wing", [](MultiblockGrid& grid) {
        std::vector<std::string> names;
        for (const Zone& zone : grid.zones) names.push_back(zone.name);
        for (std::size_t n = 0; n < names.size(); ++n) {
            grid.zones[n].name = "other" + names[names.size() - 1 - n];
        }
        grid.provenance = "another program";
    });
    CHECK(scratch.hexweave(compare).exit_code == 1);
    const Finished run = scratch.hexweave(compare + " --match geometry");
    INFO(run.out);
    CHECK(run.exit_code == 0);
    CHECK_THAT(run.out, Contains(" = upper"));
}

TEST_CASE("nodes that are not known are listed, not compared") {
    const Scratch scratch;
    write_box(scratch.path() / "plain.cgns", leave_alone);
    write_box(scratch.path() / "more.cgns", [](int file, int base, int zone) {
        int solution = 0;
        REQUIRE(cg_sol_write(file, base, zone, "Flow", Vertex, &solution) == CG_OK);
        REQUIRE(cg_goto(file, base, "end") == CG_OK);
        REQUIRE(cg_descriptor_write("Provenance", "another day") == CG_OK);
        REQUIRE(cg_descriptor_write("Remark", "a remark") == CG_OK);
    });
    const Finished run = scratch.hexweave("compare more.cgns plain.cgns");
    INFO(run.out << run.err);
    CHECK(run.exit_code == 0);
    CHECK_THAT(run.out, Contains("in the new grid: FlowSolution_t (1), /Base/box/Flow\n"));
    CHECK_THAT(run.out, Contains("in the new grid: Descriptor_t (1), /Base/Remark\n"));
    CHECK_THAT(run.out, !Contains("Provenance"));
    CHECK_THAT(scratch.hexweave("compare plain.cgns more.cgns").out, Contains("the golden grid: "));
}

TEST_CASE("parts of a file that are no structured grid are listed, not compared") {
    const Scratch scratch;
    write_box(scratch.path() / "plain.cgns", leave_alone);
    write_box(scratch.path() / "more.cgns", [](int file, int base, int zone) {
        int number = 0;
        // Before and after the box by name.
        for (const char* name : {"a_tets", "z_tets"}) {
            const cgsize_t size[3] = {8, 1, 0};
            REQUIRE(cg_zone_write(file, base, name, size, Unstructured, &number) == CG_OK);
        }
        const cgsize_t scattered[9] = {1, 1, 1, 1, 2, 1, 1, 1, 2};
        REQUIRE(cg_boco_write(file, base, zone, "dots", BCWall, PointList, 3, scattered, &number) ==
                CG_OK);
        REQUIRE(cg_base_write(file, "Other", 3, 3, &number) == CG_OK);
    });
    for (const std::string match : {"name", "geometry"}) {
        const Finished run = scratch.hexweave("compare more.cgns plain.cgns --match " + match);
        INFO(run.out << run.err);
        CHECK(run.exit_code == 0);
        CHECK_THAT(run.out, Contains("in the new grid: CGNSBase_t (1), /Other\n"));
        CHECK_THAT(run.out, Contains("in the new grid: Zone_t (2), /Base/a_tets, ...\n"));
        CHECK_THAT(run.out, Contains("in the new grid: BC_t (1), /Base/box/ZoneBC/dots\n"));
        CHECK_THAT(run.out, Contains("same: 60 points in 1 zone"));
    }
    for (const std::string command : {"quality more.cgns", "convert more.cgns new.xyz"}) {
        CHECK(scratch.hexweave(command).exit_code == 2);
    }
}

TEST_CASE("an ADF file is the same as the HDF5 file of the same grid") {
    const Scratch scratch;
    write_box(scratch.path() / "hdf5.cgns", leave_alone);
    write_box(scratch.path() / "adf.cgns", leave_alone, CG_FILE_ADF);
    CHECK(scratch.read("adf.cgns").find("ADF") < 100);
    CHECK(scratch.hexweave("compare adf.cgns hdf5.cgns").exit_code == 0);
    CHECK(scratch.hexweave("compare hdf5.cgns adf.cgns --match geometry").exit_code == 0);
}

TEST_CASE("what cannot be compared is told in one message") {
    const Scratch scratch;
    const std::string good = goldens + "scherk.cgns";
    scratch.write("text.cgns", "not a grid\n");
    scratch.write("empty.cgns", "");
    for (const std::string bad : {"text.cgns", "empty.cgns"}) {
        check_refused(scratch, bad + " " + good, "it is not a CGNS file");
        check_refused(scratch, good + " " + bad, "it is not a CGNS file");
    }
    check_refused(scratch, "none.cgns " + good, "no such file");
    check_refused(scratch, good + " .", "it is a folder");
    check_refused(scratch, good + " grid.p3d", "'hexweave convert' makes one of a Plot3D file");
    check_refused(scratch, "case.yaml " + good, "'hexweave run case.yaml' makes its grid");
    check_refused(scratch, good + " " + good + " --tolerance 0", "--tolerance");
    check_refused(scratch, good + " " + good + " --tolerance nan", "--tolerance");
    CHECK(scratch.hexweave("compare " + good + " " + good + " --match luck").exit_code == 2);
    const Finished run = scratch.hexweave("compare text.cgns " + good + " --json -");
    CHECK(run.exit_code == 2);
    CHECK(Json::parse(run.out)["exit_code"] == 2);
    CHECK(Json::parse(run.out)["comparison"].is_null());
}

TEST_CASE("missing nodes and wrong dimensions are told in one message") {
    const Scratch scratch;
    write_box(scratch.path() / "good.cgns", leave_alone);
    const auto damage = [&](const std::string& name, const std::string& parent,
                            const std::string& child, const std::vector<cgsize_t>& dimensions) {
        write_box(scratch.path() / name, leave_alone);
        int file = 0;
        REQUIRE(cg_open((scratch.path() / name).c_str(), CG_MODE_MODIFY, &file) == CG_OK);
        REQUIRE(cg_gopath(file, parent.c_str()) == CG_OK);
        REQUIRE(cg_delete_node(child.c_str()) == CG_OK);
        if (!dimensions.empty()) {
            const std::vector<double> values(100);
            cg_array_write(child.c_str(), RealDouble, static_cast<int>(dimensions.size()),
                           dimensions.data(), values.data());
        }
        REQUIRE(cg_close(file) == CG_OK);
        check_refused(scratch, name + " good.cgns", name);
        check_refused(scratch, "good.cgns " + name, name);
    };
    damage("no_x.cgns", "/Base/box/GridCoordinates", "CoordinateX", {});
    damage("no_coordinates.cgns", "/Base/box", "GridCoordinates", {});
    damage("no_zone.cgns", "/Base", "box", {});
    damage("one_axis.cgns", "/Base/box/GridCoordinates", "CoordinateY", {60});
    damage("short.cgns", "/Base/box/GridCoordinates", "CoordinateY", {3, 4, 4});
    damage("long.cgns", "/Base/box/GridCoordinates", "CoordinateY", {4, 4, 5});
}

TEST_CASE("damaged files never end the program otherwise than with a verdict or a message") {
    const Scratch scratch;
    const std::string golden = goldens + "scherk.cgns";
    const std::string bytes = slurp(golden);
    const auto compare = [&](const std::string& damaged) {
        scratch.write("damaged.cgns", damaged);
        for (const std::string& files : {"damaged.cgns " + golden, golden + " damaged.cgns"}) {
            const Finished run = scratch.hexweave("compare --quiet " + files);
            INFO(run.out << run.err);
            CHECK((run.exit_code >= 0 && run.exit_code <= 2));
            CHECK(lines(run.out + run.err) == 1);
        }
    };
    for (int part = 1; part < 8; ++part) {
        compare(bytes.substr(0, bytes.size() * static_cast<std::size_t>(part) / 8));
    }
    std::mt19937 random(7);
    for (int round = 0; round < 20; ++round) {
        std::string damaged = bytes;
        // The tree of nodes, rather than the coordinates, takes most of the file.
        for (int n = 0; n < 3; ++n) {
            damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
        }
        compare(damaged);
    }
}

TEST_CASE("golden grids are made, left alone and updated by one command") {
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path() / "kept");
    const std::string run = "run --golden kept " + shipped("scherk.yaml") + " " +
                            shipped("tanh.yaml") + " --set tolerance=1e-6";
    Finished done = scratch.hexweave(run);
    INFO(done.out << done.err);
    REQUIRE(done.exit_code == 0);
    CHECK_THAT(done.out, Contains("kept/scherk.cgns: new; sound"));
    CHECK_THAT(done.out, Contains("kept/tanh.cgns: new; sound"));
    const std::string first = scratch.read("kept/scherk.cgns");

    // Another way to the same grid leaves the file as it is.
    done =
        scratch.hexweave("run --golden kept " + shipped("scherk.yaml") + " --set tolerance=1e-7");
    CHECK_THAT(done.out, Contains("kept/scherk.cgns: unchanged; same: "));
    CHECK(scratch.read("kept/scherk.cgns") == first);

    done = scratch.hexweave("run --golden kept " + shipped("scherk.yaml") + " --set half=1.2");
    CHECK(done.exit_code == 0);
    CHECK_THAT(done.out, Contains("kept/scherk.cgns: updated; different: "));
    CHECK(scratch.read("kept/scherk.cgns") != first);
    CHECK(scratch.listing() == "kept");

    CHECK(scratch.hexweave("run --golden none " + shipped("scherk.yaml")).exit_code == 2);
    CHECK(scratch.hexweave("run a.yaml b.yaml").exit_code == 2);
    CHECK(scratch.hexweave("run --golden kept -o x.cgns a.yaml").exit_code == 2);
}

TEST_CASE("no golden grid changes unless every grid is sound") {
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path() / "kept");
    const Finished done = scratch.hexweave("run --golden kept " + shipped("scherk.yaml") + " " +
                                           shipped("tanh.yaml") + " --set tolerance=1e-30");
    CHECK(done.exit_code == 1);
    CHECK_THAT(done.err, Contains("no golden grid changed"));
    CHECK(std::filesystem::is_empty(scratch.path() / "kept"));
}

namespace {

constexpr int large_side = 216;  // nodes along each axis: 10,077,696 in all

/// A cube of cells, written layer by layer.
void write_large(const std::filesystem::path& path) {
    int file = 0;
    int base = 0;
    int zone = 0;
    int number = 0;
    cg_set_file_type(CG_FILE_HDF5);
    REQUIRE(cg_open(path.c_str(), CG_MODE_WRITE, &file) == CG_OK);
    REQUIRE(cg_base_write(file, "Base", 3, 3, &base) == CG_OK);
    const int n = large_side;
    const cgsize_t size[9] = {n, n, n, n - 1, n - 1, n - 1, 0, 0, 0};
    REQUIRE(cg_zone_write(file, base, "cube", size, Structured, &zone) == CG_OK);
    std::vector<double> layer(static_cast<std::size_t>(n) * n);
    const char* names[] = {"CoordinateX", "CoordinateY", "CoordinateZ"};
    for (int axis = 0; axis < 3; ++axis) {
        for (int k = 0; k < n; ++k) {
            for (int place = 0; place < n * n; ++place) {
                layer[static_cast<std::size_t>(place)] = axis == 0   ? place % n
                                                         : axis == 1 ? place / n
                                                                     : k;
            }
            const cgsize_t first[3] = {1, 1, k + 1};
            const cgsize_t last[3] = {n, n, k + 1};
            REQUIRE(cg_coord_partial_write(file, base, zone, RealDouble, names[axis], first, last,
                                           layer.data(), &number) == CG_OK);
        }
    }
    REQUIRE(cg_close(file) == CG_OK);
}

}  // namespace

TEST_CASE("ten million points are compared in less memory than one of the grids takes") {
    const Scratch scratch;
    write_large(scratch.path() / "golden.cgns");
    std::filesystem::copy_file(scratch.path() / "golden.cgns", scratch.path() / "new.cgns");
    int file = 0;
    int number = 0;
    REQUIRE(cg_open((scratch.path() / "new.cgns").c_str(), CG_MODE_MODIFY, &file) == CG_OK);
    const cgsize_t node[3] = {100, 200, 150};
    const double moved = 99 + 1e-3;
    REQUIRE(cg_coord_partial_write(file, 1, 1, RealDouble, "CoordinateX", node, node, &moved,
                                   &number) == CG_OK);
    REQUIRE(cg_close(file) == CG_OK);

    // One grid takes 242 MB. Sanitizers need terabytes of addresses for themselves.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    const std::string limit;
#else
    const std::string limit = "ulimit -v 160000; ";
#endif
    const Finished run = scratch.shell(
        limit + "'" HEXWEAVE_PROGRAM "' compare --json found.json -j 2 new.cgns golden.cgns");
    INFO(run.out << run.err);
    CHECK(run.exit_code == 1);
    const Json found = Json::parse(scratch.read("found.json"))["comparison"];
    CHECK(found["points"] == large_side * large_side * large_side);
    CHECK(found["beyond"] == 1);
    CHECK(found["in_cells"]["node"] == Json({100, 200, 150}));
    CHECK(found["in_cells"]["size"].get<double>() == Approx(1e-3));
}
