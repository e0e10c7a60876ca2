// SPDX-License-Identifier: Apache-2.0
// The surface grid of the ONERA M6 wing on its CAD, run as a user runs it: every point is on the
// CAD, and the borders of its patches do not show.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <vector>

#include "geometry/cad.h"
#include "geometry/surface_set.h"
#include "io/cgns.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;

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

}  // namespace

TEST_CASE("the grid of the M6 wing on its CAD is on the CAD, also on what that is trimmed to") {
    const Scratch scratch;
    const Finished run =
        scratch.hexweave("run " + shipped("onera_m6_cad.yaml") +
                         " --set chordwise=32 --set spanwise=12 --set cap_cells=12");
    INFO(run.out << run.err);
    REQUIRE(run.exit_code == 0);
    const MultiblockGrid grid = read_cgns(scratch.path() / "onera_m6_cad.cgns");
    const CadResult cad =
        read_cad(slurp(HEXWEAVE_SOURCE_DIR "/data/wings/AileM6_with_sharp_TE.stp"));
    REQUIRE(cad.file);
    const std::map<std::string, WingSide> sides{
        {"up", side_of(*cad.file, {114, 110, 111, 109, 105})},
        {"low", side_of(*cad.file, {113, 107, 108, 106, 104})}};
    for (const Zone& zone : grid.zones) {
        INFO(zone.name);
        const WingSide& side = sides.at(zone.name.substr(zone.name.find('_') + 1));
        const Extent e = zone.points.extent();
        double inside = 0;
        double on_edges = 0;
        double out = 0;
        std::vector<int> on_patch(5);
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) {
                const Vec3 p = zone.points(i, j);
                const PatchPoint foot = side.surfaces.nearest(p);
                const bool edge = i == 0 || j == 0 || i == e.ni - 1 || j == e.nj - 1;
                double& worst = edge ? on_edges : inside;
                worst = std::max(worst, foot.point.distance);
                const auto patch = static_cast<std::size_t>(foot.patch);
                ++on_patch[patch];
                if (!edge) out = std::max(out, out_of_box(side.faces[patch], p));
            }
        }
        CHECK(inside < 1e-10 * side.surfaces.size());
        // The two sides share edges that each has for its own: within the gap of 2e-7 m.
        CHECK(on_edges < 2e-7);
        CHECK(out < 1e-4);
        CHECK(on_patch[0] > 0);
        CHECK(on_patch[2] > 0);
        if (zone.name.rfind("cap", 0) == 0) {
            // The rear triangle is smaller than a cell.
            CHECK(on_patch[1] > 0);
            CHECK(on_patch[3] > 0);
        }
    }
}

#endif
