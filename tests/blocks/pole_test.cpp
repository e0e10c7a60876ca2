// SPDX-License-Identifier: Apache-2.0
// Grids with poles: a disc collapsed to its centre, a cylinder to its axis, a ball to its middle.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "blocks/assemble.h"
#include "blocks/soundness.h"
#include "edges/edge_grid.h"
#include "elliptic/fold_count.h"
#include "faces/edge_functions.h"
#include "topology/resolve_helpers.h"

using namespace hexweave;
using namespace hexweave::test;

namespace {

std::string sector(const std::string& method) {
    return R"(
vertices: {c: [0, 0], a: [1, 0], b: [0, 1]}
curves: {rim: {circle: {center: [0, 0], radius: 1}}}
edges:
  pole: {at: c}
  arc: {from: a, to: b, along: rim, through: [0.7, 0.7], cells: 12}
  ra: {from: c, to: a, cells: 10}
  rb: {from: c, to: b}
faces:
  f: {imin: pole, imax: arc, jmin: ra, jmax: rb, method: )" +
           method + R"(}
boundaries:
  wall: {type: BCWall, sides: [arc, ra, rb]}
)";
}

/// Two halves of a cylinder collapsed to its axis; the lower one is turned.
std::string cylinder(const std::string& method) {
    const std::string how = ", method: " + method + "}\n";
    return R"(
curves:
  rim0: {circle: {center: [0, 0], radius: 1}}
  rim1: {of: rim0, translate: [0, 0, 3]}
vertices: {o0: [0, 0, 0], a0: [1, 0, 0], b0: [-1, 0, 0], o1: [0, 0, 3], a1: [1, 0, 3], b1: [-1, 0, 3]}
edges:
  pole0: {at: o0, cells: 12}
  pole1: {at: o1}
  low0: {at: o0}
  low1: {at: o1, cells: 10}
  axis: {from: o0, to: o1, cells: 6}
  side_a: {from: a0, to: a1}
  side_b: {from: b0, to: b1}
  ray_a0: {from: o0, to: a0, cells: 8}
  ray_a1: {from: o1, to: a1}
  ray_b0: {from: o0, to: b0}
  ray_b1: {from: o1, to: b1}
  upper0: {from: a0, to: b0, along: rim0, through: [0, 1]}
  lower0: {from: b0, to: a0, along: rim0, through: [0, -1]}
  upper1: {from: a1, to: b1, along: rim1, through: [0, 1, 3]}
  lower1: {from: b1, to: a1, along: rim1, through: [0, -1, 3]}
faces:
  cut_a: {imin: axis, imax: side_a, jmin: ray_a0, jmax: ray_a1}
  cut_b: {imin: axis, imax: side_b, jmin: ray_b0, jmax: ray_b1}
  disc0: {imin: pole0, imax: upper0, jmin: ray_a0, jmax: ray_b0)" +
           how + R"(  disc1: {imin: pole1, imax: upper1, jmin: ray_a1, jmax: ray_b1)" + how +
           R"(  low_disc0: {imin: low0, imax: lower0, jmin: ray_b0, jmax: ray_a0)" + how +
           R"(  low_disc1: {imin: low1, imax: lower1, jmin: ray_b1, jmax: ray_a1)" + how +
           R"(  wall: {imin: side_a, imax: side_b, jmin: upper0, jmax: upper1, method: algebraic}
  low_wall: {imin: side_b, imax: side_a, jmin: lower0, jmax: lower1, method: algebraic}
  centre: {imin: axis, imax: axis, jmin: pole0, jmax: pole1}
  low_centre: {imin: axis, imax: axis, jmin: low0, jmax: low1}
blocks:
  up: {imin: centre, imax: wall, jmin: cut_a, jmax: cut_b, kmin: disc0, kmax: disc1)" +
           how +
           R"(  low: {jmin: low_centre, jmax: low_wall, kmin: cut_b, kmax: cut_a, imin: low_disc0, imax: low_disc1)" +
           how + R"(boundaries:
  wall: {type: BCWall, sides: [wall, low_wall]}
  ends: {type: BCInflow, sides: [disc0, disc1, low_disc0, low_disc1]}
)";
}

/// An eighth of a ball: the middle is a face of four poles, the north pole one of the sphere's.
const std::string octant = R"(
curves:
  xy: {circle: {center: [0, 0, 0], radius: 1}}
  xz: {of: xy, rotate: pi / 2, axis: [1, 0, 0]}
  yz: {of: xz, rotate: pi / 2}
surfaces:
  ball: {sphere: {center: [0, 0, 0], radius: 1}}
vertices: {o: [0, 0, 0], x: [1, 0, 0], w: [0, 1, 0], z: [0, 0, 1]}
edges:
  equator: {from: x, to: w, along: xy, through: [1, 1], cells: 10}
  east: {from: x, to: z, along: xz, through: [1, 0, 1], cells: 8}
  west: {from: w, to: z, along: yz, through: [0, 1, 1]}
  top: {at: z}
  ox: {from: o, to: x, cells: 6}
  ow: {from: o, to: w}
  oz: {from: o, to: z}
  middle_j: {at: o}
  middle_top: {at: o}
  middle_x: {at: o}
  middle_w: {at: o}
faces:
  shell: {imin: east, imax: west, jmin: equator, jmax: top, surface: ball}
  middle: {imin: middle_x, imax: middle_w, jmin: middle_j, jmax: middle_top}
  ground: {imin: middle_j, imax: equator, jmin: ox, jmax: ow}
  axis: {imin: oz, imax: oz, jmin: middle_top, jmax: top}
  plane_x: {imin: ox, imax: oz, jmin: middle_x, jmax: east}
  plane_w: {imin: ow, imax: oz, jmin: middle_w, jmax: west}
blocks:
  ball: {imin: plane_x, imax: plane_w, jmin: ground, jmax: axis, kmin: middle, kmax: shell}
boundaries:
  shell: {type: BCFarfield, sides: [shell]}
  planes: {type: BCSymmetryPlane, sides: [ground, plane_x, plane_w]}
)";

struct Made {
    Topology topology;
    std::vector<FaceGrid> faces;
    std::vector<BlockGrid> blocks;
    MultiblockGrid grid;
};

Made made(const std::string& text) {
    REQUIRE(faults(text) == "");
    Made all{resolved(text), {}, {}, {}};
    CHECK(broken_promise(all.topology) == "");
    all.faces = make_faces(all.topology, make_edges(all.topology));
    all.blocks = make_blocks(all.topology, all.faces);
    all.grid = assemble(all.topology, all.faces, all.blocks);
    check_sound(all.grid);
    return all;
}

void check_solved(const SolveResult& solve) {
    CHECK(solve.folded_after == 0);
    CHECK(solve.status == SolveStatus::converged);
}

}  // namespace

TEST_CASE("edge functions of a pole are those beside it; of poles alone, equal steps") {
    const std::vector<Vec3> pole(3, Vec3{1, 2, 3});
    const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}, {4, 0, 0}};
    const std::vector<Vec3> other{{0, 0, 0}, {3, 0, 0}, {4, 0, 0}};
    using Values = std::vector<std::vector<double>>;
    CHECK(parallel_edge_functions({pole, line}, {{}, {}}) == Values{{0, 0.25, 1}, {0, 0.25, 1}});
    CHECK(parallel_edge_functions({pole, pole}, {{}, {}}) == Values{{0, 0.5, 1}, {0, 0.5, 1}});
    // The poles at (0, 0) and (0, 1) take the values of their neighbours (1, 0) and (1, 1).
    CHECK(parallel_edge_functions({pole, line, pole, other}, {{}, {}, {}, {}}) ==
          Values{{0, 0.25, 1}, {0, 0.25, 1}, {0, 0.75, 1}, {0, 0.75, 1}});
    CHECK(parallel_edge_functions({pole, pole, line, other}, {{}, {}, {}, {}}) ==
          Values{{0, 0.25, 1}, {0, 0.75, 1}, {0, 0.25, 1}, {0, 0.75, 1}});
}

TEST_CASE("an algebraic sector collapsed to its centre is the polar grid") {
    const Made sectors = made(sector("algebraic"));
    const PointField& points = sectors.faces[0].points;
    CHECK(points.extent() == Extent{11, 13, 1});
    double error = 0;
    for (int j = 0; j < 13; ++j) {
        for (int i = 0; i < 11; ++i) {
            const double angle = j * std::numbers::pi / 24;
            const Vec3 exact{i / 10.0 * std::cos(angle), i / 10.0 * std::sin(angle), 0};
            error = std::max(error, distance(points(i, j), exact));
        }
        CHECK(points(0, j) == Vec3{});
    }
    CHECK(error < 1e-14);
    CHECK(count_folded(points) == 0);
}

TEST_CASE("folded cells beside a pole are seen") {
    PointField points = made(sector("algebraic")).faces[0].points;
    points.set(1, 6, 0, -1.0 * points(1, 6));
    CHECK(count_folded(points) >= 2);
}

TEST_CASE("an elliptic sector is its own mirror image") {
    const Made sectors = made(sector("elliptic"));
    check_solved(sectors.faces[0].solve);
    const PointField& points = sectors.faces[0].points;
    double error = 0;
    for (int j = 0; j < 13; ++j) {
        for (int i = 0; i < 11; ++i) {
            const Vec3 p = points(i, j);
            error = std::max(error, distance(points(i, 12 - j), {p.y, p.x, 0}));
        }
    }
    CHECK(error < 1e-5);
}

TEST_CASE("a cylinder of two blocks collapsed to its axis") {
    const Made algebraic = made(cylinder("algebraic"));
    const PointField& points = algebraic.grid.zones[0].points;
    double error = 0;
    for (int k = 0; k < 7; ++k) {
        for (int j = 0; j < 13; ++j) {
            for (int i = 0; i < 9; ++i) {
                const double angle = j * std::numbers::pi / 12;
                const Vec3 exact{i / 8.0 * std::cos(angle), i / 8.0 * std::sin(angle), k / 2.0};
                error = std::max(error, distance(points(i, j, k), exact));
            }
            CHECK(points(0, j, k) == points(0, 0, k));
        }
    }
    CHECK(error < 1e-13);
    CHECK(algebraic.grid.interfaces.size() == 2);
    CHECK(algebraic.grid.families.back().type == "BCDegenerateLine");
    CHECK(algebraic.grid.patches.size() == 8);
    for (const BlockGrid& block : algebraic.blocks) CHECK(block.solve.folded_after == 0);

    const Made elliptic = made(cylinder("elliptic"));
    for (const BlockGrid& block : elliptic.blocks) check_solved(block.solve);
}

TEST_CASE("an eighth of a ball has a point for a side, and a pole of the sphere on another") {
    const Made ball = made(octant);
    check_solved(ball.blocks[0].solve);
    const PointField& points = ball.grid.zones[0].points;
    for (std::size_t f = 0; f < ball.faces.size(); ++f) {
        if (!ball.topology.faces[f].is_collapsed()) check_solved(ball.faces[f].solve);
    }
    double off = 0;
    for (int j = 0; j < 9; ++j) {
        for (int i = 0; i < 11; ++i) {
            CHECK(points(i, j, 0) == Vec3{});
            off = std::max(off, std::abs(norm(points(i, j, 6)) - 1));
        }
    }
    CHECK(off < 1e-12);
    std::vector<std::string> types;
    for (const Family& family : ball.grid.families) types.push_back(family.type);
    CHECK(types == std::vector<std::string>{"BCFarfield", "BCSymmetryPlane", "BCDegenerateLine",
                                            "BCDegeneratePoint"});
}
