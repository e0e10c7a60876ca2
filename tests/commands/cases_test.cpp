// SPDX-License-Identifier: Apache-2.0
// Every shipped case, run as a user runs it; the big one in a coarse form. The facts are checked on
// the file that came out, not on what the program says of it.
#include <fmt/core.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "core/multiblock.h"
#include "core/periodic_image.h"
#include "io/cgns.h"
#include "quality/measure.h"
#include "quality/walls.h"
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
            const Finished run = scratch.hexweave("run " + shipped(c.name + ".yaml") + " " +
                                                  c.overrides + " --strict --json report.json");
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

namespace {

/// Calls look(point) for every node of every patch of a family.
void for_each_node(const MultiblockGrid& grid, const std::string& family,
                   const std::function<void(const Vec3&)>& look) {
    for (const BoundaryPatch& patch : grid.patches) {
        if (grid.families[static_cast<std::size_t>(patch.family)].name != family) continue;
        const PointField& x = grid.zones[static_cast<std::size_t>(patch.zone)].points;
        for (int k = patch.box.begin[2]; k <= patch.box.end[2]; ++k)
            for (int j = patch.box.begin[1]; j <= patch.box.end[1]; ++j)
                for (int i = patch.box.begin[0]; i <= patch.box.end[0]; ++i) look(x(i, j, k));
    }
}

const std::string small_annulus =
    " --set span_cells=6 --set ring_cells=20 --set front_cells=12 --set side_cells=20 "
    "--set rear_cells=14 --set gap_cells=8 --set inlet_cells=10 --set outlet_cells=16";

}  // namespace

TEST_CASE("the sides of the vane passages are images by the pitch, to the last bit") {
    const double step = 2 * std::acos(-1.0) / 36;
    for (const auto& [name, sizes, periodicity] :
         {std::tuple<std::string, std::string, Periodicity>{"vane", "", {{}, {}, {0, 0.85, 0}}},
          {"vane_annulus", small_annulus, {{}, {-step, 0, 0}, {}}}}) {
        INFO(name);
        const Scratch scratch;
        REQUIRE(scratch.hexweave("run --quiet " + shipped(name + ".yaml") + sizes + " -o vane.cgns")
                    .exit_code == 0);
        const MultiblockGrid grid = read_cgns(scratch.path() / "vane.cgns");
        const PeriodicMap map = periodic_map(periodicity);
        int periodic = 0;
        for (const Interface& interface : grid.interfaces) {
            if (!interface.periodic) continue;
            ++periodic;
            CHECK(not_images(grid, interface, map) == 0);
        }
        CHECK(periodic == 3);
    }
}

TEST_CASE("the vane's annulus lies between its hub and shroud, first cells off the vane held") {
    const Scratch scratch;
    REQUIRE(scratch
                .hexweave("run --quiet " + shipped("vane_annulus.yaml") + small_annulus +
                          " -o vane.cgns")
                .exit_code == 0);
    const MultiblockGrid grid = read_cgns(scratch.path() / "vane.cgns");
    const double middle = 0.85 * 36 / (2 * std::acos(-1.0));
    for_each_node(grid, "hub", [&](const Vec3& p) {
        CHECK(std::hypot(p.y, p.z) == Approx(middle - 0.3).epsilon(1e-12));
    });
    for_each_node(grid, "shroud", [&](const Vec3& p) {
        CHECK(std::hypot(p.y, p.z) == Approx(middle + 0.3).epsilon(1e-12));
    });
    for (const Zone& zone : grid.zones) {
        if (zone.name != "front" && zone.name != "top" && zone.name != "rear" &&
            zone.name != "bottom") {
            continue;
        }
        const Extent e = zone.points.extent();
        for (int k = 0; k < e.nk; ++k) {
            for (int i = 0; i < e.ni; ++i) {
                CHECK(distance(zone.points(i, 0, k), zone.points(i, 1, k)) ==
                      Approx(2e-5).epsilon(0.05));
            }
        }
    }
}

TEST_CASE("the transfinite wall of the conical pipe lies on the cone") {
    const Scratch scratch;
    REQUIRE(scratch
                .hexweave("run --quiet " + shipped("pipe.yaml") +
                          " --set across=8 --set radial=8 --set along=10 -o pipe.cgns")
                .exit_code == 0);
    std::size_t nodes = 0;
    double worst = 0;
    for_each_node(read_cgns(scratch.path() / "pipe.cgns"), "wall", [&](const Vec3& p) {
        ++nodes;
        worst = std::max(worst, std::abs(std::hypot(p.x, p.y) - (0.5 - 0.1 * p.z)));
    });
    CHECK(nodes == std::size_t{4} * 9 * 11);
    CHECK(worst < 1e-14);
}

TEST_CASE("the side planes of the swept wing are exact and its sections alike") {
    const Scratch scratch;
    REQUIRE(scratch
                .hexweave("run --quiet " + shipped("swept_wing.yaml") +
                          " --set span_cells=4 --set wall_cells=16 --set wake_cells=8 "
                          "--set normal=16 -o wing.cgns")
                .exit_code == 0);
    const MultiblockGrid grid = read_cgns(scratch.path() / "wing.cgns");
    for_each_node(grid, "root", [](const Vec3& p) { CHECK(p.y == 0); });
    for_each_node(grid, "tip", [](const Vec3& p) { CHECK(p.y == 2); });
    // Every section of the upper side is the root's, moved along the sweep.
    for (const Zone& zone : grid.zones) {
        if (zone.name != "upper") continue;
        const Extent e = zone.points.extent();
        for (int k = 0; k < e.nk; ++k) {
            for (int i = 0; i < e.ni; ++i) {
                const Vec3 root = zone.points(i, 0, e.nk - 1);
                const Vec3 p = zone.points(i, 0, k);
                CHECK(p.x - p.y * std::tan(std::acos(-1.0) / 6) == Approx(root.x).margin(1e-13));
                CHECK(p.z == Approx(root.z).margin(1e-13));
            }
        }
    }
}

TEST_CASE("the rounded tip's wall is on the wing, its far field on the sphere, its planes exact") {
    const Scratch scratch;
    REQUIRE(scratch
                .hexweave("run --quiet " + shipped("rounded_tip.yaml") +
                          " --set chordwise=20 --set spanwise=16 --set normal=16 -o tip.cgns")
                .exit_code == 0);
    const MultiblockGrid grid = read_cgns(scratch.path() / "tip.cgns");
    for_each_node(grid, "root", [](const Vec3& p) { CHECK(p.y == 0); });
    for_each_node(grid, "middle", [](const Vec3& p) { CHECK(p.z == 0); });
    for_each_node(grid, "farfield", [](const Vec3& p) {
        CHECK(distance(p, {0.5, 0, 0}) == Approx(10).epsilon(1e-12));
    });
    double thickest_at_tip = 0;
    for_each_node(grid, "wing", [&](const Vec3& p) {
        const double chord = 1 + 0.44 * p.y / 1.5;
        const double x = (p.x + p.y * std::tan(std::acos(-1.0) / 6)) / chord;
        const double q = std::max(0.0, (-p.y - 1.35) / 0.15);
        const double half = 0.6 * (0.2969 * std::sqrt(std::max(x, 0.0)) +
                                   x * (-0.1260 + x * (-0.3516 + x * (0.2843 - x * 0.1036))));
        // Squared, for the slope of the root is infinite at the tip.
        CHECK(p.z * p.z / (chord * chord) ==
              Approx(half * half * std::max(0.0, 1 - q * q)).margin(1e-14));
        if (q > 0.5) thickest_at_tip = std::max(thickest_at_tip, p.z);
    });
    CHECK(thickest_at_tip > 0.02);
}

TEST_CASE("the walls of the wing-body are those of the model, its planes are exact") {
    const Scratch scratch;
    REQUIRE(scratch
                .hexweave("run --quiet " + shipped("wing_body.yaml") +
                          " --set chordwise=16 --set spanwise=12 --set beyond=6 --set lens=4 "
                          "--set wake_cells=16 --set inner=8 --set outer=8 --json report.json "
                          "-o body.cgns")
                .exit_code == 0);
    const MultiblockGrid grid = read_cgns(scratch.path() / "body.cgns");
    for_each_node(grid, "symmetry", [](const Vec3& p) { CHECK(p.z == 0); });
    std::size_t at_tip = 0;
    for_each_node(grid, "wing", [&](const Vec3& p) {
        CHECK(p.z > 0.5);
        CHECK(p.z < 4 + 1e-12);
        at_tip += std::abs(p.z - 4) < 1e-12;
        // Nothing of it is before its straight leading edge, or behind its straight trailing edge.
        const double leading = 0.7498 - (4 - p.z) * (0.7498 + 0.1126) / (4 - 0.5514);
        const double trailing = 1.1498 - (4 - p.z) * (1.1498 - 0.8005) / (4 - 0.5044);
        CHECK(p.x > leading - 1e-3);
        CHECK(p.x < trailing + 1e-3);
    });
    CHECK(at_tip == std::size_t{17} * 5 + 2 * 17);  // the cap, and the rims of both sides
    // The body's greatest section, from its nose on; behind its base the sting's.
    for_each_node(grid, "body", [](const Vec3& p) {
        const bool sting = p.x > 4.2;
        CHECK(p.x > -3.1);
        CHECK(p.y < (sting ? 0.63 : 0.851));
        CHECK(p.y > (sting ? -0.13 : -0.351));
        CHECK(p.z >= 0);
        CHECK(p.z < (sting ? 0.381 : 0.601));
        if (p.z == 0 && p.x > -1.6 && p.x < -0.6) {
            CHECK(std::min(std::abs(p.y - 0.85), std::abs(p.y + 0.35)) < 1e-4);
        }
    });
    for_each_node(grid, "pole_line", [](const Vec3& p) { CHECK(p.z > 4 - 1e-12); });
    const Json report = Json::parse(scratch.read("report.json"))["report"];
    for (const Json& solve : report["solves"]) {
        for (const Json& side : solve["heights"]) CHECK(side["median"] == Approx(1).epsilon(0.01));
    }
    // The patches of the model gape where they meet at the nose, by no more than this.
    for (const Json& solve : report["solves"]) {
        if (!solve["off_surface"].is_null()) CHECK(solve["off_surface"]["distance"] < 1e-3);
    }
}

TEST_CASE("first cells off the swept wing are as high as asked, all over it") {
    const Scratch scratch;
    REQUIRE(scratch
                .hexweave("run --quiet " + shipped("swept_wing.yaml") +
                          " --set span_cells=6 --set wall_cells=32 --set wake_cells=12 "
                          "--set normal=48 --json report.json -o wing.cgns")
                .exit_code == 0);
    const MultiblockGrid grid = read_cgns(scratch.path() / "wing.cgns");
    for (const Zone& zone : grid.zones) {
        if (zone.name != "upper" && zone.name != "lower") continue;
        const Extent e = zone.points.extent();
        for (int k = 0; k < e.nk; ++k) {
            for (int i = 0; i < e.ni; ++i) {
                CHECK(distance(zone.points(i, 0, k), zone.points(i, 1, k)) ==
                      Approx(1e-5).epsilon(0.01));
            }
        }
    }
    int held = 0;
    const Json solves = Json::parse(scratch.read("report.json"))["report"]["solves"];
    for (const Json& solve : solves) {
        for (const Json& side : solve["heights"]) {
            CHECK(side["asked"][0].get<double>() == Approx(1e-5));
            CHECK(side["least"].get<double>() > 0.99);
            CHECK(side["greatest"].get<double>() < 1.01);
            ++held;
        }
    }
    CHECK(held == 9);
}

TEST_CASE("the grid about airfoil and flap is held at both walls, smooth and nearly square") {
    const Scratch scratch;
    REQUIRE(scratch
                .hexweave("run --quiet " + shipped("two_element.yaml") +
                          " --json report.json -o flap.cgns")
                .exit_code == 0);
    const Json report = Json::parse(scratch.read("report.json"))["report"];
    CHECK(report["angles"]["least"] > 50);
    CHECK(report["angles"]["greatest"] < 125);
    REQUIRE(report["walls"].size() == 2);
    for (const Json& wall : report["walls"]) {
        INFO(wall["family"]);
        CHECK(wall["least_height"].get<double>() == Approx(1e-5).epsilon(1e-3));
        CHECK(wall["greatest_height"].get<double>() == Approx(1e-5).epsilon(1e-3));
        CHECK(wall["greatest_angle"] < 1);
        CHECK(wall["greatest_angle_beside_ends"] < 1.5);
    }
    for (const Json& zone : report["zones"]) {
        const bool at_five_fold_points = zone["name"] == "wing" || zone["name"] == "under";
        INFO(zone["name"]);
        CHECK(zone["growth"][0]["ratio"] < 1.45);
        CHECK(zone["growth"][1]["ratio"] < (at_five_fold_points ? 1.8 : 1.32));
    }
    for (const Json& interface : report["interfaces"]) {
        INFO(interface["name"]);
        CHECK(interface["growth"]["ratio"] < (interface["name"] == "front" ? 2.5 : 1.7));
    }
}

TEST_CASE("the flap of two elements may be moved and turned, and takes its lines along") {
    for (const char* placed :
         {"--set flap_y=-0.03 --set angle=0.44", "--set flap_x=1 --set angle=0.26"}) {
        INFO(placed);
        const Scratch scratch;
        const Finished run = scratch.hexweave("run " + shipped("two_element.yaml") + " " + placed +
                                              " -o moved.cgns");
        INFO(run.out << run.err);
        CHECK(run.exit_code == 0);
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

TEST_CASE("the transfinite start grid of the obstacle is severely folded") {
    const Scratch scratch;
    REQUIRE(
        scratch.hexweave("run --json - " + shipped("obstacle.yaml") + " >report.json").exit_code ==
        0);
    const Json report = Json::parse(scratch.read("report.json"));
    CHECK(report["report"]["solves"][0]["folded_before"] > 500);
    CHECK(report["report"]["solves"][0]["folded_after"] == 0);
    CHECK(report["report"]["folded"] == 0);
}

namespace {

/// The greatest distance of the grid's nodes from Scherk's surface z = f(x, y), to first order: the
/// distance in z over the length of the normal (-f_x, -f_y, 1).
double distance_to_scherk(const Scratch& scratch, int cells, int stretched) {
    const Finished run =
        scratch.hexweave("run --quiet " + shipped("scherk.yaml") +
                         " --set tolerance=1e-6 --set cells=" + std::to_string(cells) +
                         " --set stretched=" + std::to_string(stretched) + " -o s.cgns");
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    const PointField points = read_cgns(scratch.path() / "s.cgns").zones.at(0).points;
    double worst = 0;
    for (std::size_t n = 0; n < points.extent().nodes(); ++n) {
        const Vec3 p = points[n];
        const Vec3 normal{-std::tan(p.x), std::tan(p.y), 1};
        const double in_z = p.z - std::log(std::cos(p.y) / std::cos(p.x));
        worst = std::max(worst, std::abs(in_z) / norm(normal));
    }
    return worst;
}

}  // namespace

TEST_CASE(
    "the Scherk grid nears the exact surface with second order, however its edges are spaced") {
    const Scratch scratch;
    for (const int stretched : {0, 1}) {
        const double coarse = distance_to_scherk(scratch, 40, stretched);
        const double medium = distance_to_scherk(scratch, 80, stretched);
        const double fine = distance_to_scherk(scratch, 160, stretched);
        INFO("distances " << coarse << ", " << medium << ", " << fine);
        CHECK(std::log2(coarse / medium) > 1.8);
        CHECK(std::log2(medium / fine) > 1.88);
        CHECK(fine < 5e-4);
    }
}

namespace {

/// The greatest displacement between two grids, relative to the shortest edge at each node.
double greatest_difference(const PointField& a, const PointField& b) {
    const Extent e = a.extent();
    const std::array<Node, 6> steps{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
    double worst = 0;
    for (int k = 0; k < e.nk; ++k)
        for (int j = 0; j < e.nj; ++j)
            for (int i = 0; i < e.ni; ++i) {
                double shortest = 1e300;
                for (const Node& s : steps) {
                    const Node n{i + s[0], j + s[1], k + s[2]};
                    if (n[0] < 0 || n[0] >= e.ni || n[1] < 0 || n[1] >= e.nj || n[2] < 0 ||
                        n[2] >= e.nk) {
                        continue;
                    }
                    shortest = std::min(shortest, distance(a(i, j, k), a(n[0], n[1], n[2])));
                }
                worst = std::max(worst, distance(a(i, j, k), b(i, j, k)) / shortest);
            }
    return worst;
}

/// A shipped case with the start grid folded on purpose.
std::string folded_start(const std::string& name) {
    std::string text = slurp(shipped(name + ".yaml"));
    const std::size_t at = text.find("solver: {");
    REQUIRE(at != std::string::npos);
    return text.insert(at + 9, "start: folded, ");
}

}  // namespace

TEST_CASE("the grid does not depend on the start grid, folded or not") {
    const std::string coarse_pipe = " --set across=8 --set radial=12 --set along=10";
    for (const auto& [name, sizes] :
         {std::pair<std::string, std::string>{"naca0012", ""}, {"pipe", coarse_pipe}}) {
        const Scratch scratch;
        const auto arguments = [&sizes = sizes](const std::string& config, const char* grid) {
            return fmt::format("run '{}' --set tolerance=1e-8{} --json report.json -o {}", config,
                               sizes, grid);
        };
        scratch.write("folded.yaml", folded_start(name));
        REQUIRE(scratch.hexweave(arguments(shipped(name + ".yaml"), "plain.cgns")).exit_code == 0);
        const Finished folded = scratch.hexweave(arguments("folded.yaml", "folded.cgns"));
        INFO(name << folded.err << folded.out);
        REQUIRE(folded.exit_code == 0);
        const Json solves = Json::parse(scratch.read("report.json"))["report"]["solves"];
        CHECK(solves.back()["folded_before"] > 100);
        const MultiblockGrid a = read_cgns(scratch.path() / "plain.cgns");
        const MultiblockGrid b = read_cgns(scratch.path() / "folded.cgns");
        for (std::size_t z = 0; z < a.zones.size(); ++z) {
            CHECK(greatest_difference(a.zones[z].points, b.zones[z].points) < 1e-6);
        }
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

namespace {

Json report_of(const Scratch& scratch, const std::string& arguments) {
    const Finished run = scratch.hexweave("run --json report.json " + arguments);
    INFO(run.out << run.err);
    REQUIRE(run.exit_code == 0);
    return Json::parse(scratch.read("report.json"))["report"];
}

/// The greatest growth along i (0) or j (1), over all zones.
double greatest_growth(const Json& report, std::size_t axis) {
    double greatest = 1;
    for (const Json& zone : report["zones"]) {
        greatest = std::max(greatest, zone["growth"][axis]["ratio"].get<double>());
    }
    return greatest;
}

double share(const Json& angles, const char* within) {
    return angles[within].get<double>() / angles["corners"].get<double>();
}

}  // namespace

TEST_CASE("grid lines of the NACA 0012 leave the airfoil upright, up to its trailing edge") {
    const Scratch scratch;
    const Json report = report_of(scratch, shipped("naca0012.yaml") + " -o naca.cgns");
    const Json& wall = report["walls"][0];
    CHECK(wall["mean_angle"] < 0.8);
    CHECK(wall["greatest_angle"] < 12);
    // Beside the ends of its four patches too, but for the one column beside the trailing edge.
    MultiblockGrid grid = read_cgns(scratch.path() / "naca.cgns");
    for (BoundaryPatch& patch : grid.patches) {
        const PointField& x = grid.zones[static_cast<std::size_t>(patch.zone)].points;
        if (x(patch.box.begin[0], 0).x == 1) ++patch.box.begin[0];
        if (x(patch.box.end[0], 0).x == 1) --patch.box.end[0];
    }
    for (const WallMeasure& m : measure_walls(grid)) CHECK(m.greatest_angle_beside_ends < 12);
    // Along the lines round the airfoil, from face to face too.
    CHECK(greatest_growth(report, 0) < 1.3);
    for (const Json& interface : report["interfaces"]) CHECK(interface["growth"]["ratio"] < 1.3);
    for (const Json& solve : report["solves"]) {
        const bool at_trailing_edge = !solve["flat_at"].empty();
        CHECK(solve["orthogonality"]["passes"] == (at_trailing_edge ? 1 : 2));
        CHECK(solve["orthogonality"]["end"] == "all passes done");
    }
}

TEST_CASE("the cells of the RAE 2822 are nearly rectangles everywhere") {
    const Scratch scratch;
    const Json report = report_of(scratch, shipped("rae2822.yaml"));
    const Json& angles = report["angles"];
    CHECK(report["folded"] == 0);
    CHECK(angles["corners"] == 4 * 24576);
    CHECK(angles["least"] > 75);
    CHECK(angles["greatest"] < 105);
    CHECK(share(angles, "within_5") >= 0.89);
    CHECK(share(angles, "within_10") >= 0.98);
    CHECK(greatest_growth(report, 1) < 1.25);
    for (const Json& interface : report["interfaces"]) {
        if (interface["name"].get<std::string>().find("wake") == std::string::npos) continue;
        CHECK(interface["growth"]["ratio"] < 1.25);
    }
    const Json& wall = report["walls"][0];
    CHECK(wall["mean_angle"] < 0.2);
    CHECK(wall["greatest_angle"] < 0.6);
    CHECK(wall["greatest_angle_beside_ends"] < 0.6);
    CHECK(wall["least_height"] > 0.99e-5);
    CHECK(wall["greatest_height"] < 1.01e-5);
}
