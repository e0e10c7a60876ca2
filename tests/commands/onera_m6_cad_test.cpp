// SPDX-License-Identifier: Apache-2.0
// The ONERA M6 wing on its CAD in a coarse form, run as a user runs it: every point of the wall is
// on the CAD, the borders of its patches do not show, and no cell is folded.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geometry/cad.h"
#include "geometry/surface_set.h"
#include "io/cgns.h"
#include "quality/measure.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;
using Json = nlohmann::json;

#if HEXWEAVE_HAS_CAD

namespace {

constexpr double mm = 1e-3;

/// The five patches of a side of the wing, those that are trimmed last.
struct WingSide {
    std::vector<CadFace> faces;
    SurfaceSet surfaces;
};

WingSide side_of(const CadFile& file, const std::vector<int>& entities) {
    std::vector<CadFace> faces;
    std::vector<std::shared_ptr<const Surface>> surfaces;
    for (const int number : entities) {
        const auto entity = std::find_if(file.entities.begin(), file.entities.end(),
                                         [&](const CadEntity& e) { return e.number == number; });
        REQUIRE(entity != file.entities.end());
        faces.push_back(entity->faces.front());
        surfaces.push_back(std::make_shared<const Surface>(cad_surface(faces.back(), mm)));
    }
    return {faces, SurfaceSet(surfaces)};
}

/// How far a point is out of the box around what a face is trimmed to.
double out_of_box(const CadFace& face, const Vec3& p) {
    const auto beyond = [](double x, double low, double high) {
        return std::max({mm * low - x, x - mm * high, 0.0});
    };
    return norm({beyond(p.x, face.box.low.x, face.box.high.x),
                 beyond(p.y, face.box.low.y, face.box.high.y),
                 beyond(p.z, face.box.low.z, face.box.high.z)});
}

constexpr int chordwise = 32;
constexpr int spanwise = 12;
constexpr int cap_cells = 12;
constexpr int wake_cells = 20;
constexpr int normal = 64;

/// The grid of a coarse run, and its report.
struct CoarseRun {
    MultiblockGrid grid;
    Json report;
};

CoarseRun coarse_run() {
    const Scratch scratch;
    const Finished run = scratch.hexweave(
        "run " + shipped("onera_m6_cad.yaml") + " --json report.json" +
        fmt::format(" --set chordwise={} --set spanwise={} --set cap_cells={} --set wake_cells={}",
                    chordwise, spanwise, cap_cells, wake_cells));
    INFO(run.out << run.err);
    REQUIRE(run.exit_code == 0);
    return {read_cgns(scratch.path() / "onera_m6_cad.cgns"),
            Json::parse(scratch.read("report.json"))["report"]};
}

bool is_wing(const Zone& zone) {
    return zone.name == "upper_wing" || zone.name == "lower_wing";
}

/// How far a zone's wall is from the CAD, and what of it is on which patch. `edges` are those of
/// the two faces, the rest is `inside`; `out` is how far that is out of what patches are trimmed
/// to.
struct WallOnCad {
    double inside = 0;
    double edges = 0;
    double out = 0;
    std::array<int, 5> on_patch{};
};

WallOnCad wall_on_cad(const PointField& x, const WingSide& side) {
    const Extent e = x.extent();
    WallOnCad wall;
    for (int k = 0; k < e.nk; ++k) {
        for (int j = 0; j < e.nj; ++j) {
            const Vec3 p = x(0, j, k);
            const PatchPoint foot = side.surfaces.nearest(p);
            const bool edge = k == 0 || k == e.nk - 1 || j == 0 || j == spanwise || j == e.nj - 1;
            double& worst = edge ? wall.edges : wall.inside;
            worst = std::max(worst, foot.point.distance);
            const auto patch = static_cast<std::size_t>(foot.patch);
            ++wall.on_patch.at(patch);
            if (!edge) wall.out = std::max(wall.out, out_of_box(side.faces[patch], p));
        }
    }
    return wall;
}

}  // namespace

TEST_CASE("the wall of the M6 wing is on its CAD, also on what that is trimmed to") {
    const CoarseRun run = coarse_run();
    const CadResult cad =
        read_cad(slurp(HEXWEAVE_SOURCE_DIR "/data/wings/AileM6_with_sharp_TE.stp"));
    REQUIRE(cad.file);
    const std::map<std::string, WingSide> sides{
        {"upper_wing", side_of(*cad.file, {114, 110, 111, 109, 105})},
        {"lower_wing", side_of(*cad.file, {113, 107, 108, 106, 104})}};
    for (const Zone& zone : run.grid.zones) {
        if (!is_wing(zone)) continue;
        INFO(zone.name);
        const WingSide& side = sides.at(zone.name);
        const WallOnCad wall = wall_on_cad(zone.points, side);
        CHECK(wall.inside < 1e-10 * side.surfaces.size());
        // The two sides share edges that each has for its own: within the gap of 2e-7 m.
        CHECK(wall.edges < 2e-7);
        CHECK(wall.out < 1e-4);
        // The rear triangle is smaller than a cell.
        for (std::size_t patch = 0; patch < 4; ++patch) CHECK(wall.on_patch.at(patch) > 0);
    }
}

TEST_CASE("the M6 wing on its CAD has no folded cell, and heights as asked") {
    const CoarseRun run = coarse_run();
    CHECK(run.report["folded"] == 0);
    int held = 0;
    for (const Json& solve : run.report["solves"]) {
        INFO(solve["name"]);
        CHECK(solve["folded_after"] == 0);
        CHECK(solve["untangling"].is_null());
        if (solve["kind"] == "block") CHECK(solve["flat_at"].size() == 1);
        for (const Json& side : solve["heights"]) {
            CHECK(side["least"] > 0.98);
            CHECK(side["greatest"] < 1.02);
            ++held;
        }
    }
    CHECK(held == 8);
    for (const Zone& zone : run.grid.zones) {
        INFO(zone.name);
        const ZoneMeasure m = measure_zone(zone, 3);
        CHECK(m.flat_corners == (is_wing(zone) ? 2 * normal + 1 : 2 * wake_cells));
        CHECK(m.worst_inside > (is_wing(zone) ? 1e-2 : 1e-3));
        CHECK(m.worst_scaled_jacobian > 1e-3);
    }
}

TEST_CASE("where the sheets of the M6 wing on its CAD meet flat they are in one plane") {
    const CoarseRun run = coarse_run();
    for (const Zone& zone : run.grid.zones) {
        if (!is_wing(zone)) continue;
        INFO(zone.name);
        const PointField& x = zone.points;
        const Extent e = x.extent();
        const int leading = x(0, 0, 0).x == 0 ? 0 : e.nk - 1;
        const int trailing = e.nk - 1 - leading;
        // On the wing, whose edges on the CAD are not in the plane by themselves, to the last bit.
        double wing = 0;
        double sheets = 0;
        for (int j = 0; j < e.nj; ++j) {
            wing = std::max({wing, std::abs(x(0, j, leading).z), std::abs(x(0, j, trailing).z)});
            for (int i = 0; i < e.ni; ++i) sheets = std::max(sheets, std::abs(x(i, j, leading).z));
        }
        for (int k = 0; k < e.nk; ++k) {
            wing = std::max(wing, std::abs(x(0, e.nj - 1, k).z));
            for (int i = 0; i < e.ni; ++i) sheets = std::max(sheets, std::abs(x(i, e.nj - 1, k).z));
        }
        CHECK(wing == 0);
        CHECK(sheets < 1e-14);
    }
}

#endif
