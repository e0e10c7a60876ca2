// SPDX-License-Identifier: Apache-2.0
// Interfaces of divided and folded block sides, checked on coordinates.
#include <fmt/format.h>

#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "blocks/assemble.h"
#include "blocks/soundness.h"
#include "edges/edge_grid.h"
#include "topology/resolve_helpers.h"

using namespace hexweave;
using namespace hexweave::test;

namespace {

MultiblockGrid generated(const Topology& topology) {
    const auto edges = make_edges(topology);
    const auto faces = make_faces(topology, edges);
    return assemble(topology, faces, make_blocks(topology, faces));
}

MultiblockGrid sound_grid(const std::string& text) {
    REQUIRE(faults(text) == "");
    const Topology topology = resolved(text);
    CHECK(broken_promise(topology) == "");
    MultiblockGrid grid = generated(topology);
    check_sound(grid);
    for (const BlockGrid& block :
         make_blocks(topology, make_faces(topology, make_edges(topology)))) {
        CHECK(block.solve.folded_after == 0);
    }
    return grid;
}

/// The corners of the cube above cell (x, y) of the lattice, with its axes turned.
std::string turned_cube(int x, int y, const Orientation& axes) {
    std::vector<std::string> corners;
    for (int corner = 0; corner < 8; ++corner) {
        const int across = corner % 4;
        const Node own{across == 1 || across == 2 ? 1 : 0, across >= 2 ? 1 : 0, corner / 4};
        const Node n = map_node(axes, own, {2, 2, 2});
        corners.push_back(fmt::format("p{}{}{}", x + n[0], y + n[1], 1 + n[2]));
    }
    return fmt::format("[{}]", fmt::join(corners, ", "));
}

/// A slab whose roof is four faces, and on each of them a block of its own.
std::string four_on_one(const std::array<Orientation, 4>& axes) {
    std::string text = "vertices:\n";
    for (int z = 0; z < 3; ++z) {
        for (int y = 0; y < 3; ++y) {
            for (int x = 0; x < 3; ++x) {
                if (z == 0 && (x == 1 || y == 1)) continue;
                text += fmt::format("  p{}{}{}: [{}, {}, {}]\n", x, y, z, x + 0.1 * y * z,
                                    1.2 * y + 0.05 * x * x, z - 0.1 * x * y);
            }
        }
    }
    text += R"(edges:
  x0: {from: p001, to: p101, cells: 3}
  x1: {from: p101, to: p201, cells: 2}
  y0: {from: p011, to: p001, cells: 4}
  y1: {from: p011, to: p021, cells: 5}
  up: {from: p001, to: p000, cells: 3}
  up1: {from: p201, to: p200}
  up2: {from: p021, to: p020}
  up3: {from: p221, to: p220}
  high: {from: p001, to: p002, cells: 2}
faces:
  q00: {corners: [p001, p101, p111, p011]}
  q10: {corners: [p211, p201, p101, p111]}
  q01: {corners: [p111, p011, p021, p121]}
  q11: {corners: [p221, p121, p111, p211]}
  floor: {corners: [p000, p200, p220, p020]}
  south: {imin: up, imax: up1, jmin: p000-p200, jmax: [x0, x1]}
  north: {imin: up2, imax: up3, jmin: p020-p220, jmax: [p021-p121, p121-p221]}
  west: {imin: up, imax: up2, jmin: p000-p020, jmax: [y0, y1]}
  east: {imin: up1, imax: up3, jmin: p200-p220, jmax: [p201-p211, p211-p221]}
blocks:
  slab: {imin: west, imax: east, jmin: south, jmax: north, kmin: floor, kmax: [[q00, q10], [q01, q11]]}
)";
    std::string sides = "floor, south, north, west, east";
    for (std::size_t n = 0; n < 4; ++n) {
        const int x = static_cast<int>(n % 2);
        const int y = static_cast<int>(n / 2);
        text += fmt::format("  above{}: {{corners: {}}}\n", n, turned_cube(x, y, axes[n]));
        sides += fmt::format(", p{0}{1}2-p{2}{1}2-p{2}{3}2-p{0}{3}2", x, y, x + 1, y + 1);
        sides += x == 0 ? fmt::format(", p0{0}1-p0{0}2-p0{1}2-p0{1}1", y, y + 1)
                        : fmt::format(", p2{0}1-p2{0}2-p2{1}2-p2{1}1", y, y + 1);
        sides += y == 0 ? fmt::format(", p{0}01-p{0}02-p{1}02-p{1}01", x, x + 1)
                        : fmt::format(", p{0}21-p{0}22-p{1}22-p{1}21", x, x + 1);
    }
    return text + "boundaries:\n  all: {type: BCWall, sides: [" + sides + "]}\n";
}

/// The outline of a symmetric section in a C-type block; `sides` are the faces on jmin.
std::string c_type_block(const std::string& faces, const std::string& sides) {
    std::string text = R"yaml(
vertices: {le0: [0, 0, 0], te0: [1, 0, 0], out0: [3, 0, 0], low0: [3, 0, -2], high0: [3, 0, 2], le1: [0, 1, 0], te1: [1, 1, 0], out1: [3, 1, 0], low1: [3, 1, -2], high1: [3, 1, 2]}
curves:
  up0: {naca: "0012", side: upper, rotate: pi / 2, axis: [1, 0, 0]}
  up1: {of: up0, translate: [0, 1, 0]}
  down0: {of: up0, mirror: {normal: [0, 0, 1]}}
  down1: {of: up1, mirror: {normal: [0, 0, 1]}}
  outer0: {formula: ["3 - 5 * sin(t)", 0, "-2 * cos(t)"], range: [0, pi]}
  outer1: {of: outer0, translate: [0, 1, 0]}
edges:
  wake0: {from: te0, to: out0, cells: 5}
  wake1: {from: te1, to: out1}
  over0: {from: le0, to: te0, along: up0, cells: 7}
  over1: {from: le1, to: te1, along: up1}
  under0: {from: le0, to: te0, along: down0, cells: 6}
  under1: {from: le1, to: te1, along: down1}
  far0: {from: low0, to: high0, along: outer0}
  far1: {from: low1, to: high1, along: outer1}
  down: {from: out0, to: low0, cells: 8}
  down_: {from: out1, to: low1}
  up: {from: out0, to: high0}
  up_: {from: out1, to: high1}
  te: {from: te1, to: te0, cells: 4}
  le: {from: le0, to: le1}
  end: {from: out0, to: out1}
  low: {from: low0, to: low1}
  high: {from: high0, to: high1}
faces:
  wake: {imin: te, imax: end, jmin: wake0, jmax: wake1, method: algebraic}
  far: {imin: low, imax: high, jmin: far0, jmax: far1, method: algebraic}
  root: {imin: down, imax: up, jmin: [wake0, under0, over0, wake0], jmax: far0}
  tip: {imin: down_, imax: up_, jmin: [wake1, under1, over1, wake1], jmax: far1}
  below: {imin: end, imax: low, jmin: down, jmax: down_}
  above: {imin: end, imax: high, jmin: up, jmax: up_}
)yaml";
    text += faces;
    text += "blocks:\n  c: {imin: below, imax: above, jmin: " + sides +
            ", jmax: far, kmin: tip, kmax: root}\n";
    return text + "boundaries:\n  rest: {type: BCWall, sides: [far, root, tip, below, above, ";
}

}  // namespace

TEST_CASE("four blocks meet the parts of one side, with i of one against j of the other") {
    std::vector<Orientation> all;
    for (const Orientation& in_plane : face_orientations()) {
        Orientation o = in_plane;
        if (determinant(o) < 0) o.axes[2] = -3;
        all.push_back(o);
        all.push_back({{o.axes[2], o.axes[0], o.axes[1]}});
        all.push_back({{o.axes[1], o.axes[2], o.axes[0]}});
    }
    for (std::size_t n = 0; n < all.size(); ++n) {
        const auto pick = [&](std::size_t m) { return all[(n + m) % all.size()]; };
        const MultiblockGrid grid = sound_grid(four_on_one({pick(0), pick(5), pick(11), pick(16)}));
        CHECK(grid.zones.size() == 5);
        CHECK(grid.interfaces.size() == 8);
        for (const Interface& interface : grid.interfaces) {
            CHECK(determinant(interface.orientation) == 1);
        }
    }
}

TEST_CASE("a block meets itself where a sheet is folded along one of its sides") {
    const std::string text = c_type_block(
        "  over: {imin: le, imax: te, jmin: over0, jmax: over1, method: algebraic}\n"
        "  under: {imin: le, imax: te, jmin: under0, jmax: under1, method: algebraic}\n",
        "[wake, under, over, wake]");
    const MultiblockGrid grid = sound_grid(text + "over, under]}\n");
    REQUIRE(grid.interfaces.size() == 1);
    const Interface& fold = grid.interfaces[0];
    CHECK(fold.box == IndexBox{{0, 0, 0}, {5, 0, 4}});
    CHECK(fold.donor_box == IndexBox{{23, 0, 0}, {18, 0, 4}});
    CHECK(fold.orientation == Orientation{{-1, -2, 3}});
    CHECK(grid.patches.size() == 7);
}
