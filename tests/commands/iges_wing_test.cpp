// SPDX-License-Identifier: Apache-2.0
// The wing from an IGES file: its grid against the surfaces of the file.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <string>

#include "core/multiblock.h"
#include "geometry/cad.h"
#include "geometry/surface_projection.h"
#include "io/cgns.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;
namespace fs = std::filesystem;

TEST_CASE("every point of the wing from an IGES file is on its patch") {
    if (!can_read_cad()) return;
    const Scratch scratch;
    const Finished run = scratch.hexweave("run --quiet " + shipped("iges_wing.yaml") +
                                          " --set chordwise=30 --set round=8");
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    const CadResult cad = read_cad(slurp(HEXWEAVE_SOURCE_DIR "/data/wings/taper_wing.igs"));
    REQUIRE(cad.file);
    const std::map<std::string, std::size_t> patches{{"inner_up", 0}, {"inner_low", 1},
                                                     {"outer_up", 2}, {"outer_low", 3},
                                                     {"cap_up", 4},   {"cap_low", 5}};
    const MultiblockGrid grid = read_cgns(scratch.path() / "iges_wing.cgns");
    REQUIRE(grid.zones.size() == patches.size());
    for (const Zone& zone : grid.zones) {
        const CadEntity& entity = cad.file->entities[patches.at(zone.name)];
        const SurfaceProjection surface(cad_surface(entity.faces.front(), 1));
        const Extent e = zone.points.extent();
        double worst = 0;
        for (int j = 0; j < e.nj; ++j) {
            SurfacePoint foot = surface.nearest(zone.points(0, j));
            for (int i = 0; i < e.ni; ++i) {
                foot = surface.nearest_from(zone.points(i, j), foot.parameters);
                worst = std::max(worst, foot.distance);
            }
        }
        INFO(zone.name);
        CHECK(worst < 1e-10 * surface.size());
    }
}

TEST_CASE("the cap of the wing from an IGES file has a pole") {
    if (!can_read_cad()) return;
    const Scratch scratch;
    REQUIRE(scratch
                .hexweave("run --quiet " + shipped("iges_wing.yaml") +
                          " --set chordwise=30 --set round=8")
                .exit_code == 0);
    for (const Zone& zone : read_cgns(scratch.path() / "iges_wing.cgns").zones) {
        if (zone.name.rfind("cap_", 0) != 0) continue;
        for (int j = 1; j < zone.points.extent().nj; ++j) {
            CHECK(zone.points(0, j) == zone.points(0, 0));
        }
    }
}
