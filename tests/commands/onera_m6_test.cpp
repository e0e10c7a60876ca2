// SPDX-License-Identifier: Apache-2.0
// The ONERA M6 wing in a coarse form, run as a user runs it: what its grid must be by its shape and
// its topology, checked on the file that came out.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "geometry/airfoil.h"
#include "io/cgns.h"
#include "quality/measure.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;
using Json = nlohmann::json;

namespace {

// With fewer cells outwards than in the full grid heights could not be held without cells that grow
// too fast.
constexpr int normal = 64;
constexpr int wake_cells = 20;
const std::string coarse =
    " --set chordwise=24 --set spanwise=12 --set cap_cells=8 --set wake_cells=20";

constexpr double root_chord = 0.810491;
constexpr double tip_chord = 0.455914;
constexpr double semispan = 1.1963;

bool is_wing(const Zone& zone) {
    return zone.name == "upper_wing" || zone.name == "lower_wing";
}

double leading_edge(double y) {
    return std::tan(29.999 * std::acos(-1.0) / 180) * y;
}

/// The distance of a point from the wing or, beyond the tip section, from the cap: that of the
/// section of its place from the point, or from where the cap's half circle through it begins.
double distance_from_wing(const Curve& section, const Vec3& p) {
    const double y = std::min(p.y, semispan);
    const double chord = root_chord + (tip_chord - root_chord) * y / semispan;
    const double height = std::hypot(p.y - y, p.z);
    return chord * project(section, {(p.x - leading_edge(y)) / chord, height / chord, 0}).distance;
}

/// The report of a run whose solver takes `flat_edge_exponent`, as the file says where it is empty.
Json report_with(const Scratch& scratch, const std::string& flat_edge_exponent) {
    std::string text = slurp(shipped("onera_m6.yaml"));
    const std::string place = "solver: {";
    const std::size_t at = text.find(place);
    REQUIRE(at != std::string::npos);
    if (!flat_edge_exponent.empty()) {
        text.insert(at + place.size(), "flat_edge_exponent: " + flat_edge_exponent + ", ");
    }
    const std::string data = "../data";
    text.replace(text.find(data), data.size(), HEXWEAVE_SOURCE_DIR "/data");
    scratch.write("m6.yaml", text);
    const Finished run = scratch.hexweave("run m6.yaml -o m6.cgns --json report.json" + coarse);
    INFO(run.out << run.err);
    REQUIRE(run.exit_code == 0);
    return Json::parse(scratch.read("report.json"))["report"];
}

}  // namespace

TEST_CASE("the wall of the ONERA M6 is on the wing and its cap, the other boundaries in place") {
    const Scratch scratch;
    report_with(scratch, "");
    const MultiblockGrid grid = read_cgns(scratch.path() / "m6.cgns");
    const Curve section =
        *airfoil_from_text(slurp(HEXWEAVE_SOURCE_DIR "/data/airfoils/onera_m6_streamwise.dat"),
                           AirfoilContent::symmetric_half, {AirfoilSide::upper, false, 1.0})
             .curve;
    double worst = 0;
    double farthest_out = 0;
    std::size_t on_cap = 0;
    for (const BoundaryPatch& patch : grid.patches) {
        const std::string& family = grid.families[static_cast<std::size_t>(patch.family)].name;
        const PointField& x = grid.zones[static_cast<std::size_t>(patch.zone)].points;
        for (int k = patch.box.begin[2]; k <= patch.box.end[2]; ++k)
            for (int j = patch.box.begin[1]; j <= patch.box.end[1]; ++j)
                for (int i = patch.box.begin[0]; i <= patch.box.end[0]; ++i) {
                    const Vec3 p = x(i, j, k);
                    if (family == "symmetry") CHECK(p.y == 0);
                    if (family == "outflow") CHECK(p.x == Approx(1 + 10 * root_chord));
                    if (family == "farfield") {
                        CHECK(norm({std::min(p.x - 1, 0.0), p.y, p.z}) ==
                              Approx(10 * root_chord).epsilon(1e-12));
                    }
                    if (family != "wing") continue;
                    worst = std::max(worst, distance_from_wing(section, p));
                    farthest_out = std::max(farthest_out, p.y);
                    if (p.y > semispan) ++on_cap;
                }
    }
    CHECK(worst < 1e-10);
    // The tip section is 9.73 % thick; its thickest place need not have a node.
    CHECK(farthest_out == Approx(semispan + 0.0487 * tip_chord).epsilon(1e-3));
    CHECK(on_cap > std::size_t{4} * 24);
}

TEST_CASE("the ONERA M6 has no folded cell, before untangling with the exponent for flat edges") {
    const Scratch scratch;
    const Json report = report_with(scratch, "");
    CHECK(report["folded"] == 0);
    for (const Json& solve : report["solves"]) {
        INFO(solve["name"]);
        CHECK(solve["folded_after"] == 0);
        CHECK(solve["untangling"].is_null());
        if (solve["kind"] == "block") CHECK(solve["flat_at"].size() == 1);
    }
    for (const Zone& zone : read_cgns(scratch.path() / "m6.cgns").zones) {
        INFO(zone.name);
        const ZoneMeasure m = measure_zone(zone, 3);
        // Two corners beside every cell of the edge at 180 degrees; and at the trailing edge of the
        // tip, where all three edges of the wing block lie in the plane z = 0.
        CHECK(m.flat_corners == (is_wing(zone) ? 2 * normal + 1 : 2 * wake_cells));
        CHECK(m.worst_inside > (is_wing(zone) ? 1e-2 : 1e-3));
        CHECK(m.worst_scaled_jacobian > 1e-3);
    }
}

TEST_CASE("the ONERA M6 has no folded cell after untangling with arc lengths as edge functions") {
    const Scratch scratch;
    const Json report = report_with(scratch, "1");
    CHECK(report["folded"] == 0);
    long untangled = 0;
    for (const Json& solve : report["solves"]) {
        if (solve["untangling"].is_null()) continue;
        untangled += solve["untangling"]["folded_before"].get<long>();
    }
    CHECK(untangled > 0);
}

TEST_CASE("first cells off the ONERA M6 are as high as asked, all over the wing") {
    const Scratch scratch;
    const Json report = report_with(scratch, "");
    int held = 0;
    for (const Json& solve : report["solves"]) {
        for (const Json& side : solve["heights"]) {
            INFO(solve["name"]);
            CHECK(side["least"] > 0.98);
            CHECK(side["greatest"] < 1.02);
            ++held;
        }
    }
    CHECK(held == 8);
    for (const Zone& zone : read_cgns(scratch.path() / "m6.cgns").zones) {
        if (!is_wing(zone)) continue;
        const PointField& x = zone.points;
        const Extent e = x.extent();
        const int leading = x(0, 0, 0).x == 0 ? 0 : e.nk - 1;
        for (int j = 0; j < e.nj; ++j) {
            for (const int k : {0, e.nk - 1}) {
                const double chord =
                    root_chord *
                    std::pow(tip_chord / root_chord, distance(x(0, 0, k), x(0, j, k)) /
                                                         distance(x(0, 0, k), x(0, e.nj - 1, k)));
                CHECK(distance(x(0, j, k), x(1, j, k)) ==
                      Approx((k == leading ? 1e-5 : 2e-5) * chord).epsilon(0.02));
            }
        }
    }
}
