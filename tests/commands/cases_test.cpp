// SPDX-License-Identifier: Apache-2.0
// Every shipped case, run as a user runs it; the big one in a coarse form. The facts are checked on
// the file that came out, not on what the program says of it.
#include <fmt/core.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/multiblock.h"
#include "io/cgns.h"
#include "quality/measure.h"
#include "tests/commands/images.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;
using Json = nlohmann::json;

namespace {

struct ShippedCase {
    std::string name;
    std::string overrides;  // a coarse form where the shipped one is big
    std::size_t zones;
    std::size_t cells;
    std::string expected_of_vtk;  // tests/tools/vtk_check.py
};

const std::vector<ShippedCase> shipped_cases{
    {"naca0012", "", 4, 8192,
     "--zones front_up=33x65x1 rear_up=33x65x1 rear_low=33x65x1 front_low=33x65x1 --families "
     "airfoil farfield"},
    {"rae2822", "", 4, 24576,
     "--zones upper=81x97x1 lower=81x97x1 wake_up=49x97x1 wake_low=49x97x1 --families airfoil "
     "farfield outflow"},
    {"two_element", "", 8, 47212,
     "--zones wing=169x115x1 wake_up=95x115x1 slot=58x77x1 slot_wake=45x77x1 nose=75x39x1 "
     "flap_wake=45x39x1 under=53x55x1 under_wake=45x55x1 "
     "--families airfoil flap farfield outflow"},
    {"half_cylinder", "", 10, 2048,
     "--zones lower_e=17x13x1 upper_e=17x13x1 upper_w=17x13x1 lower_w=17x13x1 side_e=17x13x1 "
     "corner_e=17x17x1 top_e=13x17x1 top_w=13x17x1 corner_w=17x17x1 side_w=17x13x1 "
     "--families cylinder symmetry top inflow outflow"},
    {"vane", "", 12, 18624,
     "--zones front=41x41x1 top=61x41x1 rear=41x41x1 bottom=61x41x1 inlet_low=33x25x1 "
     "inlet=33x41x1 inlet_up=33x25x1 below=61x25x1 above=61x25x1 outlet_low=57x25x1 "
     "wake=57x41x1 outlet_up=57x25x1 --families vane inflow outflow"},
    {"vane_annulus",
     "--set span_cells=8 --set ring_cells=20 --set front_cells=12 --set side_cells=20 "
     "--set rear_cells=14 --set gap_cells=8 --set inlet_cells=10 --set outlet_cells=16",
     12, 19200,
     "--zones front=13x21x9 top=21x21x9 rear=15x21x9 bottom=21x21x9 inlet_low=11x9x9 "
     "inlet=11x13x9 inlet_up=11x9x9 below=21x9x9 above=21x9x9 outlet_low=17x9x9 wake=17x15x9 "
     "outlet_up=17x9x9 --families vane hub shroud inflow outflow"},
    {"cascade", "", 30, 22080,
     "--zones passage1.nose=25x25x1 passage1.top=49x25x1 passage1.tail=25x25x1 "
     "passage1.bottom=49x25x1 passage1.before=17x25x1 passage1.behind=25x25x1 "
     "passage2.nose=25x25x1 passage2.top=49x25x1 passage2.tail=25x25x1 "
     "passage2.bottom=49x25x1 passage2.before=17x25x1 passage2.behind=25x25x1 "
     "passage3.nose=25x25x1 passage3.top=49x25x1 passage3.tail=25x25x1 "
     "passage3.bottom=49x25x1 passage3.before=17x25x1 passage3.behind=25x25x1 "
     "passage4.nose=25x25x1 passage4.top=49x25x1 passage4.tail=25x25x1 "
     "passage4.bottom=49x25x1 passage4.before=17x25x1 passage4.behind=25x25x1 "
     "passage5.nose=25x25x1 passage5.top=49x25x1 passage5.tail=25x25x1 "
     "passage5.bottom=49x25x1 passage5.before=17x25x1 passage5.behind=25x25x1 "
     "--families struts inlet outlet floor roof"},
    {"obstacle", "", 1, 24000, "--zones ring=401x61x1 --families body farfield"},
    {"scherk", "", 1, 1600, "--zones surface=41x41x1 --families rim"},
    {"pipe", "--set across=8 --set radial=12 --set along=10", 5, 4480,
     "--zones middle=9x9x11 east=13x9x11 north=13x9x11 west=13x9x11 south=13x9x11 "
     "--families wall inlet outlet"},
    {"swept_wing", "--set span_cells=6 --set wall_cells=20 --set wake_cells=10 --set normal=24", 4,
     8640,
     "--zones upper=21x25x7 lower=21x25x7 wake_up=11x25x7 wake_low=11x25x7 "
     "--families wing farfield outflow root tip"},
    {"rounded_tip", "--set chordwise=24 --set spanwise=20 --set normal=20", 1, 9600,
     "--zones above=25x21x21 --families wing farfield root middle"},
    {"onera_m6",
     "--set chordwise=24 --set spanwise=12 --set cap_cells=8 --set wake_cells=20 --set normal=24",
     4, 42240,
     "--zones upper_wing=25x21x25 lower_wing=25x21x25 upper_wake=21x25x21 lower_wake=21x25x21 "
     "--families wing symmetry farfield outflow"},
    {"wing_body",
     "--set chordwise=16 --set spanwise=12 --set beyond=6 --set lens=4 --set wake_cells=16 "
     "--set inner=8 --set outer=8",
     5, 18816,
     "--zones upper_wing=17x19x17 lower_wing=17x19x17 upper_wake=17x17x19 lower_wake=17x17x19 "
     "tip=17x5x7 --families wing body symmetry farfield outflow pole_line"},
    {"iges_wing", "", 6, 5760,
     "--zones inner_up=49x21x1 inner_low=49x21x1 outer_up=49x29x1 outer_low=49x29x1 cap_up=49x13x1 "
     "cap_low=49x13x1 --families root pole_point"},
    {"onera_m6_cad",
     "--set chordwise=24 --set spanwise=12 --set cap_cells=8 --set wake_cells=20 --set normal=24",
     4, 42240,
     "--zones upper_wing=25x21x25 lower_wing=25x21x25 upper_wake=21x25x21 lower_wake=21x25x21 "
     "--families wing symmetry farfield outflow"},
    {"unit_square", "", 4, 6400,
     "--zones mild=41x41x1 strong=41x41x1 first_mild=41x41x1 first_strong=41x41x1 --families rim"},
    {"tanh", "", 2, 3200, "--zones left=41x41x1 right=41x41x1 --families rim"},
    {"pylon", "", 7, 14336,
     "--zones nose=65x33x1 side_in=65x33x1 side_out=65x33x1 wake_in=33x33x1 wake_out=33x33x1 "
     "inboard=97x33x1 outboard=97x33x1 --families pylon rim"},
};

/// Nodes of the interfaces that are not periodic whose two sides differ in any bit, by the file.
int mismatched_nodes(const MultiblockGrid& grid) {
    int count = 0;
    for (const Interface& interface : grid.interfaces) {
        if (!interface.periodic) count += not_images(grid, interface, {});
    }
    return count;
}

}  // namespace

TEST_CASE("every shipped case gives a sound grid that other programs read") {
    for (const ShippedCase& c : shipped_cases) {
        if (!HEXWEAVE_HAS_CAD && (c.name == "iges_wing" || c.name == "onera_m6_cad")) continue;
        DYNAMIC_SECTION(c.name) {
            const Scratch scratch;
            const std::string config = shipped(c.name + ".yaml") + " " + c.overrides;
            CHECK(scratch.hexweave("check " + config + " --strict").exit_code == 0);
            const Finished run = scratch.hexweave("run " + config + " --json report.json");
            INFO(run.out << run.err);
            REQUIRE(run.exit_code == 0);
            REQUIRE(scratch.has(c.name + ".cgns"));

            const Json report = Json::parse(scratch.read("report.json"));
            CHECK(report["exit_code"] == 0);
            CHECK(report["report"]["sound"] == true);
            CHECK(report["report"]["cells"] == c.cells);
            for (const Json& s : report["report"]["spacings"]) {
                if (!s["first_asked"].is_null()) {
                    CHECK(s["first_got"].get<double>() ==
                          Approx(s["first_asked"].get<double>()).epsilon(1e-6));
                }
                if (!s["last_asked"].is_null()) {
                    CHECK(s["last_got"].get<double>() ==
                          Approx(s["last_asked"].get<double>()).epsilon(1e-6));
                }
            }

            const MultiblockGrid grid = read_cgns(scratch.path() / (c.name + ".cgns"));
            CHECK(grid.zones.size() == c.zones);
            CHECK(mismatched_nodes(grid) == 0);
            std::size_t cells = 0;
            for (const Zone& zone : grid.zones) {
                const ZoneMeasure measured = measure_zone(zone, grid.physical_dimension);
                cells += measured.cells;
                CHECK(measured.folded == 0);
                CHECK(measured.worst_scaled_jacobian > 0);
            }
            CHECK(cells == c.cells);

            const Finished check = scratch.shell("cgnscheck -w3 " + c.name + ".cgns");
            INFO(check.out);
            CHECK(check.out.find("ERROR") == std::string::npos);
            CHECK(check.out.find("WARNING") == std::string::npos);

            const Finished vtk =
                scratch.shell("/usr/bin/python3 " HEXWEAVE_SOURCE_DIR "/tests/tools/vtk_check.py " +
                              c.name + ".cgns " + c.expected_of_vtk);
            INFO(vtk.out << vtk.err);
            CHECK(vtk.exit_code == 0);
        }
    }
}

TEST_CASE("the bytes do not depend on the threads, nor on the run") {
    // The wing's four blocks are large enough to be made one by one with all threads inside.
    for (const auto& [config, counts] : {
             std::pair<std::string, std::string>{"naca0012", ""},
             {"pipe", " --set across=6 --set radial=8 --set along=8"},
             {"meander19", " --set along=96 --set normal=48"},
             {"scherk", ""},
             {"vane", ""},
             {"vane_annulus", small_annulus},
             {"swept_wing",
              " --set span_cells=12 --set wall_cells=48 --set wake_cells=24 --set normal=40"},
         }) {
        INFO(config);
        const Scratch scratch;
        const std::string run = "run --quiet " + shipped(config + ".yaml") + counts;
        REQUIRE(scratch.hexweave(run + " -j 1 -o one.cgns").exit_code == 0);
        REQUIRE(scratch.hexweave(run + " -j 2 -o two.cgns").exit_code == 0);
        REQUIRE(scratch.hexweave(run + " -j 7 -o seven.cgns").exit_code == 0);
        CHECK(scratch.read("one.cgns").size() > 10000);
        CHECK(scratch.read("one.cgns") == scratch.read("two.cgns"));
        CHECK(scratch.read("one.cgns") == scratch.read("seven.cgns"));
    }
}

TEST_CASE("the good cases of the tests run to sound grids") {
    int cases = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(HEXWEAVE_SOURCE_DIR "/tests/cases/good")) {
        if (entry.path().extension() != ".yaml") continue;
        ++cases;
        const Scratch scratch;
        const Finished run = scratch.hexweave("run '" + entry.path().string() + "' -o good.cgns");
        INFO(entry.path().filename() << run.err << run.out);
        CHECK(run.exit_code == 0);
    }
    CHECK(cases >= 3);
}

TEST_CASE("the case on the README's first pages runs and is sound") {
    const std::string readme = slurp(HEXWEAVE_SOURCE_DIR "/README.md");
    const std::size_t begin = readme.find("```yaml\n") + 8;
    const Scratch scratch;
    scratch.write("hump.yaml", readme.substr(begin, readme.find("```", begin) - begin));
    const Finished run = scratch.hexweave("run --strict hump.yaml --set count=64 -o fine.cgns");
    INFO(run.err);
    CHECK(run.exit_code == 0);
    CHECK(scratch.has("fine.cgns"));
    const Finished plot = scratch.hexweave("plot fine.cgns -o hump.png");
    INFO(plot.err);
    CHECK(plot.exit_code == 0);
    CHECK(scratch.read("hump.png").substr(1, 3) == "PNG");
}

TEST_CASE("the O-grid of the pages about walls is sound, its lines at right angles to the wall") {
    const std::string page = slurp(HEXWEAVE_SOURCE_DIR "/docs/walls.md");
    const std::size_t begin = page.find("```yaml\n") + 8;
    const Scratch scratch;
    scratch.write("ring.yaml", page.substr(begin, page.find("```", begin) - begin));
    const Finished run = scratch.hexweave("run --strict --json ring.json ring.yaml");
    INFO(run.err << run.out);
    REQUIRE(run.exit_code == 0);
    const Json report = Json::parse(scratch.read("ring.json"))["report"];
    CHECK(report["walls"][0]["mean_angle"].get<double>() < 1);
}
