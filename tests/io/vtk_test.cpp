// SPDX-License-Identifier: Apache-2.0
// VTK files as VTK itself reads them.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "io/cgns_samples.h"
#include "io/grid_file.h"
#include "io/scratch.h"
#include "io/vtk.h"
#include "quality/cell_corners.h"
#include "quality/cell_measures.h"

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

/// A zone with our measures of its cells, as tests/tools/vtk_quality.py reads it.
void write_measured(const Zone& zone, int physical_dimension, const std::filesystem::path& path) {
    const Vec3 plane = zone_plane(zone.points, physical_dimension);
    const Extent e = zone.points.extent();
    std::vector<double> scaled;
    std::vector<double> jacobian;
    std::vector<double> volume;
    std::vector<double> skip;
    for (int k = 0; k < std::max(e.nk - 1, 1); ++k) {
        for (int j = 0; j + 1 < e.nj; ++j) {
            for (int i = 0; i + 1 < e.ni; ++i) {
                const Node cell{i, j, k};
                const CellMeasures measures = measure_cell(zone.points, cell, plane);
                scaled.push_back(measures.scaled_jacobian);
                volume.push_back(measures.volume);
                jacobian.push_back(std::numeric_limits<double>::infinity());
                skip.push_back(0);
                for (const CellCorner& corner : cell_corners(zone.points, cell, plane)) {
                    jacobian.back() = std::min(jacobian.back(), corner.jacobian);
                    if (corner.counted_apart()) skip.back() = 1;
                }
            }
        }
    }
    write_vtk_grid(
        zone.points, {},
        {{"scaled_jacobian", scaled}, {"jacobian", jacobian}, {"volume", volume}, {"skip", skip}},
        path);
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

TEST_CASE("VTK's vtkMeshQuality finds the same Jacobians and volumes in real grids") {
    for (const char* name : {"swept_wing", "rounded_tip", "naca0012"}) {
        const Scratch scratch;
        const MultiblockGrid grid =
            read_grid(fmt::format("{}/tests/goldens/{}.cgns", HEXWEAVE_SOURCE_DIR, name));
        std::string command = "/usr/bin/python3 " HEXWEAVE_SOURCE_DIR "/tests/tools/vtk_quality.py";
        for (const Zone& zone : grid.zones) {
            const auto path = scratch.path(zone.name + ".vts");
            write_measured(zone, grid.physical_dimension, path);
            command += " " + path.string();
        }
        const Outcome outcome = run(command);
        if (outcome.status == 77) {
            WARN(outcome.output);
            return;
        }
        INFO(name << ": " << outcome.output);
        REQUIRE(outcome.status == 0);
        std::istringstream numbers(outcome.output);
        std::size_t cells = 0;
        double scaled_jacobian = 1;
        double jacobian = 1;
        double volume = 1;
        numbers >> cells >> scaled_jacobian >> jacobian >> volume;
        CHECK(cells > 2000);
        CHECK(scaled_jacobian < 1e-12);
        CHECK(jacobian < 1e-12);
        CHECK(volume < 1e-9);  // of thin cells: thirds of their height are rounded
    }
}
