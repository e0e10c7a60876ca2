// SPDX-License-Identifier: Apache-2.0
// The shipped cases of grids on given surfaces, by their numbers.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "core/multiblock.h"
#include "geometry/control_mesh.h"
#include "geometry/plot3d_file.h"
#include "geometry/surface_projection.h"
#include "io/cgns.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;

namespace {

MultiblockGrid grid_of(const std::string& name) {
    const Scratch scratch;
    const Finished run = scratch.hexweave("run " + shipped(name + ".yaml") + " --strict");
    INFO(run.out << run.err);
    REQUIRE(run.exit_code == 0);
    return read_cgns(scratch.path() / (name + ".cgns"));
}

const PointField& points_of(const MultiblockGrid& grid, const std::string& zone) {
    for (const Zone& z : grid.zones) {
        if (z.name == zone) return z.points;
    }
    FAIL("no zone " << zone);
    return grid.zones.front().points;
}

/// The greatest distance of a grid from the uniform one of a unit square.
double off_uniform(const PointField& points, const Vec3& corner) {
    const Extent e = points.extent();
    double worst = 0;
    for (int j = 0; j < e.nj; ++j) {
        for (int i = 0; i < e.ni; ++i) {
            const Vec3 uniform{static_cast<double>(i) / (e.ni - 1),
                               static_cast<double>(j) / (e.nj - 1), 0};
            worst = std::max(worst, distance(points(i, j), corner + uniform));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("elliptic grids of the unit square are uniform, those of the parameters are not") {
    const MultiblockGrid grid = grid_of("unit_square");
    CHECK(off_uniform(points_of(grid, "mild"), {0, 0, 0}) < 1e-6);
    CHECK(off_uniform(points_of(grid, "strong"), {1.25, 0, 0}) < 1e-6);
    CHECK(off_uniform(points_of(grid, "first_mild"), {0, 1.25, 0}) > 0.04);
    CHECK(off_uniform(points_of(grid, "first_strong"), {1.25, 1.25, 0}) > 0.07);
}

TEST_CASE("grids of the steep surface are the same from either mesh of control points") {
    const MultiblockGrid grid = grid_of("tanh");
    const PointField& left = points_of(grid, "left");
    const PointField& right = points_of(grid, "right");
    double apart = 0;
    double off = 0;
    for (std::size_t n = 0; n < left.extent().nodes(); ++n) {
        const Vec3 p = left[n];
        apart = std::max(apart, distance(p, right[n] - Vec3{1.25, 0, 0}));
        const double square = (p.x - 1) * (p.x - 1) + (p.y - 1) * (p.y - 1);
        off = std::max(off, std::abs(p.z - std::tanh(15 * (0.25 - square)) / 8));
    }
    CHECK(off < 1e-3);       // the interpolation's error
    CHECK(apart < 2 * off);  // and no more than both have
}

TEST_CASE("the grid around the pylon lies on the wing and meets the pylon at right angles") {
    const MultiblockGrid grid = grid_of("pylon");
    const Plot3dSurface wing =
        read_plot3d_surface(slurp(HEXWEAVE_SOURCE_DIR "/data/surfaces/wing_lower_61x41.xyz"));
    REQUIRE(wing.error.empty());
    const SurfaceProjection lower(control_surface(wing.mesh));
    for (const Zone& zone : grid.zones) {
        double off = 0;
        for (std::size_t n = 0; n < zone.points.extent().nodes(); n += 7) {
            off = std::max(off, lower.nearest(zone.points[n]).distance);
        }
        CHECK(off < 1e-10 * lower.size());
    }
    for (const std::string name : {"nose", "side_in", "side_out"}) {
        const PointField& points = points_of(grid, name);
        double slant = 0;
        for (int i = 5; i < points.extent().ni - 5; ++i) {
            const Vec3 up = 2 * points(i, 1) - 1.5 * points(i, 0) - 0.5 * points(i, 2);
            const Vec3 along = points(i + 1, 0) - points(i - 1, 0);
            slant = std::max(slant, std::abs(dot(up, along)) / norm(up) / norm(along));
        }
        INFO(name);
        CHECK(slant < 0.05);
    }
}
