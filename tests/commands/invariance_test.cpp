// SPDX-License-Identifier: Apache-2.0
// A case that is reordered, renamed, turned, mirrored or scaled as a text gives the reordered,
// renamed, turned, mirrored or scaled grid: bit for bit where no arithmetic differs, else to the
// round-off that a solve leaves.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/multiblock.h"
#include "io/cgns.h"
#include "tests/commands/program.h"
#include "tests/commands/rewritten_case.h"

using namespace hexweave;
using namespace hexweave::testing;

namespace {

/// In cells, of grids solved to 1e-10 of a cell; what was seen is at most 6e-10, beside a pole
/// about which lines were swept in another order.
constexpr double round_off = 2e-9;

struct SmallCase {
    std::string file;
    std::string overrides = {};
    /// No arithmetic differs: names of what is made decide which way it runs, and the unfolding of
    /// a folded start adds up coordinates in their order.
    bool renamed_exactly = true;
    bool turned_exactly = true;
    /// Turned by 0.7 about z: a periodic rotation must stay about an axis of space.
    bool turns_anyhow = true;
};

std::string good_case(const std::string& name) {
    return HEXWEAVE_SOURCE_DIR "/tests/cases/good/" + name + ".yaml";
}

MultiblockGrid grid_of(const YAML::Node& written, const std::string& overrides) {
    const Scratch scratch;
    scratch.write("case.yaml", text_of(written));
    const Finished run = scratch.hexweave("run case.yaml -j 1 -o grid.cgns " + overrides);
    INFO(text_of(written) << run.out << run.err);
    REQUIRE(run.exit_code == 0);
    return read_cgns(scratch.path() / "grid.cgns");
}

const PointField& points_of(const MultiblockGrid& grid, const std::string& zone) {
    const auto found = std::find_if(grid.zones.begin(), grid.zones.end(),
                                    [&](const Zone& z) { return z.name == zone; });
    REQUIRE(found != grid.zones.end());
    return found->points;
}

/// The shortest edge at a node that has a length.
double local_size(const PointField& x, const Node& node) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int step : {-1, 1}) {
            Node n = node;
            n[axis] += step;
            if (n[axis] < 0 || n[axis] >= x.extent()[static_cast<int>(axis)]) continue;
            const double size = distance(x(node[0], node[1], node[2]), x(n[0], n[1], n[2]));
            if (size > 0) least = std::min(least, size);
        }
    }
    return least;
}

/// Where a point of the old grid is to be in the new one.
using PointMap = std::function<Vec3(const Vec3&)>;
/// The node of an old zone, of the extent given, that a node of the new one is.
using NodeMap = std::function<Node(const Node&, const Extent&)>;
/// What a zone of the old grid is called in the new one.
using NameMap = std::function<std::string(const std::string&)>;

struct Rewritten {
    NodeMap node = [](const Node& n, const Extent&) { return n; };
    PointMap point = [](const Vec3& p) { return p; };
    NameMap name = [](const std::string& zone) { return zone; };
};

/// The greatest distance of a point from where it is to be, in cells: 0 only for the same bits.
double deviation(const PointField& now, const PointField& before, const Rewritten& rewritten) {
    const Extent& e = now.extent();
    REQUIRE(e.nodes() == before.extent().nodes());
    double greatest = 0;
    for (int k = 0; k < e.nk; ++k) {
        for (int j = 0; j < e.nj; ++j) {
            for (int i = 0; i < e.ni; ++i) {
                const Node old = rewritten.node({i, j, k}, before.extent());
                const Vec3 wanted = rewritten.point(before(old[0], old[1], old[2]));
                const double off = distance(now(i, j, k), wanted);
                if (off != 0) greatest = std::max(greatest, off / local_size(now, {i, j, k}));
            }
        }
    }
    return greatest;
}

double deviation(const MultiblockGrid& now, const MultiblockGrid& before,
                 const Rewritten& rewritten = {}) {
    REQUIRE(now.zones.size() == before.zones.size());
    REQUIRE(now.interfaces.size() == before.interfaces.size());
    double greatest = 0;
    for (const Zone& zone : before.zones) {
        const PointField& there = points_of(now, rewritten.name(zone.name));
        greatest = std::max(greatest, deviation(there, zone.points, rewritten));
    }
    return greatest;
}

Vec3 image(const Motion& motion, const Vec3& p) {
    const auto row = [&](std::size_t n) {
        const auto& r = motion.rows[n];
        return r[0] * p.x + r[1] * p.y + r[2] * p.z;
    };
    return {row(0), row(1), row(2)};
}

Rewritten moved_by(const Motion& motion) {
    Rewritten rewritten;
    rewritten.point = [motion](const Vec3& p) { return image(motion, p); };
    return rewritten;
}

Node from_the_other_end(const Node& n, const Extent& e) {
    return {e.ni - 1 - n[0], n[1], n[2]};
}

const Motion quarter_turn{"{rotate: pi / 2}", {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}};
const Motion quarter_turn_about_x{"{rotate: pi / 2, axis: [1, 0, 0]}",
                                  {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}}};
const Motion turn{
    "{rotate: 0.7}",
    {{{std::cos(0.7), -std::sin(0.7), 0}, {std::sin(0.7), std::cos(0.7), 0}, {0, 0, 1}}}};
const Motion doubling{"{scale: 2}", {{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}, 2};
const Motion mirror_image{"{mirror: {normal: [1, 0, 0]}}", {{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};

void check_order_and_names(const SmallCase& small, const YAML::Node& written,
                           const MultiblockGrid& grid) {
    CHECK(deviation(grid_of(reordered(written, 3), small.overrides), grid) == 0);

    const auto names = new_names(written);
    Rewritten rewritten;
    rewritten.name = [&](const std::string& zone) { return names.at(zone); };
    const double off =
        deviation(grid_of(renamed(written, names), small.overrides), grid, rewritten);
    CHECK(off <= (small.renamed_exactly ? 0 : round_off));
}

void check_axes(const SmallCase& small, const YAML::Node& written, const MultiblockGrid& grid) {
    Rewritten rewritten;
    rewritten.node = [&](const Node& n, const Extent& e) -> Node {
        if (grid.cell_dimension == 2) return {e.ni - 1 - n[1], n[0], 0};
        return {n[2], n[0], n[1]};
    };
    CHECK(deviation(grid_of(turned_axes(written), small.overrides), grid, rewritten) <= round_off);
}

void check_motions(const SmallCase& small, const YAML::Node& written, const MultiblockGrid& grid) {
    const auto off = [&](const Motion& motion) {
        return deviation(grid_of(moved(written, motion), small.overrides), grid, moved_by(motion));
    };
    CHECK(off(quarter_turn) <= (small.turned_exactly ? 0 : round_off));
    if (grid.cell_dimension == 3) CHECK(off(quarter_turn_about_x) <= round_off);
    if (small.turns_anyhow) CHECK(off(turn) <= round_off);
    CHECK(off(doubling) <= round_off);

    Rewritten mirrored = moved_by(mirror_image);
    mirrored.node = from_the_other_end;
    const YAML::Node right_handed = along_minus_i(moved(written, mirror_image));
    CHECK(deviation(grid_of(right_handed, small.overrides), grid, mirrored) <= round_off);
}

/// A case solved so far that what is left of a solve does not count.
YAML::Node tight(const std::string& file) {
    YAML::Node written = case_of(file);
    written["solver"]["tolerance"] = "1e-10";
    written["parameters"].remove("tolerance");
    return written;
}

void check_all(const SmallCase& small) {
    INFO(small.file);
    const YAML::Node written = tight(small.file);
    const MultiblockGrid grid = grid_of(written, small.overrides);
    check_order_and_names(small, written, grid);
    check_axes(small, written, grid);
    check_motions(small, written, grid);
}

}  // namespace

TEST_CASE("a C-grid with right angles and heights at the wall is where its case puts it") {
    check_all({shipped("rae2822.yaml"),
               "--set wall_cells=24 --set wake_cells=12 --set normal=24 --set wall=1e-3 --set "
               "nose=2e-3 --set tail=1e-2"});
}

TEST_CASE("mixed O and H topologies are where their cases put them") {
    check_all({shipped("half_cylinder.yaml"), "", false});
    check_all({shipped("pipe.yaml"), "--set across=6 --set radial=8 --set along=8 --set wall=0.02",
               false});
}

TEST_CASE("an O-grid in one face is where its case puts it, from a folded start on") {
    check_all(
        {shipped("obstacle.yaml"), "--set around=60 --set normal=12 --set wall=0.05", true, false});
}

TEST_CASE("blocks about a swept wing are where their case puts them") {
    check_all({shipped("swept_wing.yaml"),
               "--set span_cells=6 --set wall_cells=20 --set wake_cells=10 --set normal=16 --set "
               "wall=1e-3",
               false});
}

TEST_CASE("a block that meets itself along a side of four faces is where its case puts it") {
    check_all({good_case("folded_wing"), "", true, false});
}

TEST_CASE("periodic grids are where their cases put them") {
    check_all({good_case("periodic_channel")});
    check_all({good_case("annular_sector"), "", false, true, false});
}

TEST_CASE("a block with poles is where its case puts it") {
    check_all({good_case("ball")});
}

TEST_CASE("an instance that is moved is the case moved") {
    const std::vector<Motion> motions{doubling, mirror_image, quarter_turn};
    for (const SmallCase& small :
         {SmallCase{shipped("half_cylinder.yaml")},
          SmallCase{shipped("pipe.yaml"),
                    "--set across=6 --set radial=8 --set along=8 --set wall=0.02"}}) {
        const YAML::Node written = tight(small.file);
        const MultiblockGrid grid = grid_of(written, small.overrides);
        for (const Motion& motion : motions) {
            INFO(small.file << " " << motion.transform);
            Rewritten rewritten = moved_by(motion);
            rewritten.name = [](const std::string& zone) { return "it." + zone; };
            if (motion.transform == mirror_image.transform) rewritten.node = from_the_other_end;
            const YAML::Node instance = as_instance(written, motion.transform);
            CHECK(deviation(grid_of(instance, small.overrides), grid, rewritten) <= round_off);
        }
    }
}
