// SPDX-License-Identifier: Apache-2.0
// The shipped wings, against what is known of them exactly: walls on the shapes, planes, first
// cells.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/multiblock.h"
#include "io/cgns.h"
#include "tests/commands/images.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;
using Json = nlohmann::json;

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
        for (const Json& side : solve["heights"]) {
            if (side["held"]) CHECK(side["median"] == Approx(1).epsilon(0.01));
        }
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
