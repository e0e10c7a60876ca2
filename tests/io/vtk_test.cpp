// SPDX-License-Identifier: Apache-2.0
// VTK files as VTK itself reads them.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstring>

#include "io/cgns_samples.h"
#include "io/grid_file.h"
#include "io/scratch.h"

using namespace hexweave;

namespace {

/// What tests/tools/vtk_blocks.py prints of a grid: sizes, bounds to the last bit, names, types.
std::string expected(const MultiblockGrid& grid) {
    std::string text;
    const auto line = [&](const std::string& block, const PointField& points, const IndexBox& box,
                          const std::string& fields) {
        double sum = 0;
        for (int k = box.begin[2]; k <= box.end[2]; ++k) {
            for (int j = box.begin[1]; j <= box.end[1]; ++j) {
                for (int i = box.begin[0]; i <= box.end[0]; ++i) {
                    const Vec3 p = points(i, j, k);
                    sum = ((sum + p.x) + p.y) + p.z;
                }
            }
        }
        text +=
            fmt::format("{} {}x{}x{} {} {}\n", block, box.end[0] - box.begin[0] + 1,
                        box.end[1] - box.begin[1] + 1, box.end[2] - box.begin[2] + 1, sum, fields);
    };
    for (const Zone& zone : grid.zones) {
        const Extent& e = zone.points.extent();
        line("zones/" + zone.name, zone.points, {{0, 0, 0}, {e.ni - 1, e.nj - 1, e.nk - 1}},
             fmt::format("Units={} Zone={}", grid.units, zone.name));
    }
    for (std::size_t family = 0; family < grid.families.size(); ++family) {
        for (const BoundaryPatch& patch : grid.patches) {
            if (patch.family != static_cast<int>(family)) continue;
            const Zone& zone = grid.zones[static_cast<std::size_t>(patch.zone)];
            line(fmt::format("boundaries/{}/{}/{}", grid.families[family].name, zone.name,
                             patch.name),
                 zone.points, patch.box,
                 fmt::format("Family={} Patch={} Type={} Units={} Zone={}",
                             grid.families[family].name, patch.name, grid.families[family].type,
                             grid.units, zone.name));
        }
    }
    return text;
}

}  // namespace

TEST_CASE("VTK reads back zones, patches and families of its own files") {
    const Scratch scratch;
    std::vector<MultiblockGrid> grids{joined_pair(2, 2, rotations(2)[1]),
                                      joined_pair(2, 3, rotations(2)[2]),
                                      joined_pair(3, 3, rotations(3)[7]), c_grid()};
    grids[2].families[1].name = "wall & <more>";
    for (const MultiblockGrid& grid : grids) {
        OutputFiles files;
        const ReservedOutput output =
            reserve(*output_by_name(scratch.path("grid.vtm").string()), files);
        write_grid(grid, output, files);
        files.commit();
        const Outcome outcome =
            run("/usr/bin/python3 " HEXWEAVE_SOURCE_DIR "/tests/tools/vtk_blocks.py " +
                scratch.path("grid.vtm").string());
        if (outcome.status == 77) {
            WARN(outcome.output);
            return;
        }
        CHECK(outcome.status == 0);
        CHECK(outcome.output == expected(grid));
    }
}
