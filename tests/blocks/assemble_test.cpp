// SPDX-License-Identifier: Apache-2.0
#include "blocks/assemble.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "blocks/soundness.h"
#include "core/orientation.h"
#include "faces/hand_built.h"

using namespace hexweave;
using namespace hexweave::test;

namespace {

MultiblockGrid assembled(const HandBuilt& built) {
    const auto faces = make_faces(built.topology, built.edges);
    const auto blocks = make_blocks(built.topology, faces);
    return assemble(built.topology, faces, blocks);
}

/// Closed circle of a radius, clockwise from +x, at a height.
std::vector<Vec3> circle(double radius, int cells, double z = 0) {
    std::vector<Vec3> points;
    for (int n = 0; n <= cells; ++n) {
        const double angle = -2 * std::numbers::pi * n / cells;
        points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
    return points;
}

std::vector<Orientation> rotations() {
    std::vector<Orientation> result;
    std::array<int, 3> axes{1, 2, 3};
    do {
        for (unsigned signs = 0; signs < 8; ++signs) {
            Orientation o{axes};
            for (std::size_t a = 0; a < 3; ++a) {
                if (signs & (1U << a)) o.axes[a] = -o.axes[a];
            }
            if (determinant(o) == 1) result.push_back(o);
        }
    } while (std::next_permutation(axes.begin(), axes.end()));
    return result;
}

constexpr std::array<Node, 8> hexahedron_nodes{Node{0, 0, 0}, Node{1, 0, 0}, Node{1, 1, 0},
                                               Node{0, 1, 0}, Node{0, 0, 1}, Node{1, 0, 1},
                                               Node{1, 1, 1}, Node{0, 1, 1}};

/// Unit cubes of a lattice, each with its own labelling, in one curved space.
class Lattice {
public:
    HandBuilt built;

    Lattice() {
        built.shape = [](const Vec3& p) {
            return Vec3{p.x + 0.1 * std::sin(p.y + 2 * p.z), p.y + 0.1 * std::sin(p.z + 2 * p.x),
                        p.z + 0.1 * std::sin(p.x + 2 * p.y)};
        };
    }

    int vertex(const Node& n) {
        const auto found = vertices_.find(n);
        if (found != vertices_.end()) return found->second;
        const Vec3 p{static_cast<double>(n[0]), static_cast<double>(n[1]),
                     static_cast<double>(n[2])};
        return vertices_[n] = built.vertex(p);
    }

    /// The cube at a place, with `o` taking its own axes to those of space.
    void cube(const Node& place, const Orientation& o) {
        std::array<int, 8> corners{};
        for (std::size_t c = 0; c < 8; ++c) {
            Node n = map_node(o, hexahedron_nodes[c], {2, 2, 2});
            for (std::size_t a = 0; a < 3; ++a) n[a] += place[a];
            corners[c] = vertex(n);
        }
        const Extent own = own_extent(o, {4, 5, 6});
        built.hexahedron(corners, {own.ni - 1, own.nj - 1, own.nk - 1});
    }

private:
    std::map<Node, int> vertices_;
};

}  // namespace

TEST_CASE("two blocks meet in all 24 labellings, at every side, and the transform is a rotation") {
    int count = 0;
    for (const Orientation& o : rotations()) {
        for (const Side side : all_sides) {
            Lattice lattice;
            // The shared face is made by the first cube, whose labelling varies too.
            lattice.cube({0, 0, 0}, rotations()[static_cast<std::size_t>(7 * count++) % 24]);
            Node place{};
            place[static_cast<std::size_t>(axis_of(side))] = is_max(side) ? 1 : -1;
            lattice.cube(place, o);
            lattice.built.bound_the_rest();
            const MultiblockGrid grid = assembled(lattice.built);
            REQUIRE(grid.interfaces.size() == 1);
            CHECK(grid.patches.size() == 10);
            CHECK(grid.cell_dimension == 3);
            CHECK(grid.physical_dimension == 3);
            check_sound(grid);
        }
    }
}

TEST_CASE("eight blocks round a vertex, all labelled differently, fit together") {
    Lattice lattice;
    const auto labels = rotations();
    for (int n = 0; n < 8; ++n) {
        lattice.cube({n & 1, (n >> 1) & 1, n >> 2}, labels[static_cast<std::size_t>(5 * n) % 24]);
    }
    lattice.built.bound_the_rest();
    const MultiblockGrid grid = assembled(lattice.built);
    CHECK(grid.interfaces.size() == 12);
    CHECK(grid.patches.size() == 24);
    check_sound(grid);
}

TEST_CASE("an O-grid of one face has a cut within its zone") {
    HandBuilt built;
    const int a = built.vertex({1, 0, 0}), b = built.vertex({3, 0, 0});
    const EdgeUse ray{built.edge(a, b, 5), false};
    const EdgeUse inner{built.edge(a, a, circle(1, 16)), false};
    const EdgeUse outer{built.edge(b, b, circle(3, 16)), false};
    built.face({{{ray}, {ray}, {inner}, {outer}}});
    built.topology.boundaries = {{{"wall", "BCWall"}, {inner.edge}, {}},
                                 {{"far", "BCFarfield"}, {outer.edge}, {}}};
    const MultiblockGrid grid = assembled(built);
    CHECK(grid.cell_dimension == 2);
    CHECK(grid.physical_dimension == 2);
    REQUIRE(grid.interfaces.size() == 1);
    const Interface& cut = grid.interfaces[0];
    CHECK(cut.zone == cut.donor);
    CHECK(cut.orientation == Orientation{});
    CHECK(cut.box == IndexBox{{0, 0, 0}, {0, 5, 0}});
    CHECK(cut.donor_box == IndexBox{{16, 0, 0}, {16, 5, 0}});
    REQUIRE(grid.patches.size() == 2);
    CHECK(grid.families[static_cast<std::size_t>(grid.patches[1].family)].name == "far");
    check_sound(grid);
}

TEST_CASE("a C-grid of one face meets itself along one side, backwards") {
    HandBuilt built;
    const int te = built.vertex({1, 0, 0}), out = built.vertex({4, 0, 0});
    const int low = built.vertex({4, -3, 0}), high = built.vertex({4, 3, 0});
    const int wake = built.edge(te, out, 6);
    std::vector<Vec3> body = circle(0.5, 12);
    for (Vec3& p : body) p = p + Vec3{0.5, 0, 0};
    std::vector<Vec3> far;
    for (int n = 0; n <= 24; ++n) {
        const double angle = -std::numbers::pi * (n / 24.0 + 0.5);
        far.push_back({4 + 7 * std::cos(angle), 3 * std::sin(angle), 0});
    }
    const int around = built.edge(te, te, body);
    const int distant = built.edge(low, high, far);
    const int lower = built.edge(out, low, 8);
    const int upper = built.edge(out, high, 8);
    built.face({{{{lower, false}},
                 {{upper, false}},
                 {{wake, true}, {around, false}, {wake, false}},
                 {{distant, false}}}});
    built.bound_the_rest();
    const MultiblockGrid grid = assembled(built);
    REQUIRE(grid.interfaces.size() == 1);
    const Interface& cut = grid.interfaces[0];
    CHECK(cut.box == IndexBox{{0, 0, 0}, {6, 0, 0}});
    CHECK(cut.donor_box == IndexBox{{24, 0, 0}, {18, 0, 0}});
    CHECK(cut.orientation == Orientation{{-1, -2, 3}});
    CHECK(grid.patches.size() == 4);
    check_sound(grid);
}

TEST_CASE("a side of several edges has an interface or a patch for each") {
    //   9 --- 10 --- 11      The lower face spans both upper ones; the right upper face is turned.
    //   |  B  |  C   |       The lower boundary is two edges.
    //   6 --- 7 ---- 8
    //   |      A     |
    //   0 --- 1 ---- 2
    HandBuilt built;
    built.law = clustered(0.3);
    std::map<int, int> v;
    for (const int n : {0, 1, 2, 6, 7, 8, 9, 10, 11}) {
        const int row = n < 3 ? 0 : n < 9 ? 1 : 2;
        const double bulge = n == 7 ? 0.2 : 0;
        v[n] = built.vertex({static_cast<double>(n % 3), row + bulge, 0});
    }
    const auto e = [&](int from, int to, int cells) {
        return built.between(v[from], v[to], cells);
    };
    e(8, 7, 5);  // against the direction of A's side
    built.face({{{e(0, 6, 4)}, {e(2, 8, 4)}, {e(0, 1, 3), e(1, 2, 5)}, {e(6, 7, 3), e(7, 8, 5)}}});
    built.face({{{e(6, 9, 6)}, {e(7, 10, 6)}, {e(6, 7, 3)}, {e(9, 10, 3)}}});
    built.face({{{e(10, 11, 5)}, {e(7, 8, 5)}, {e(10, 7, 6)}, {e(11, 8, 6)}}});
    built.bound_the_rest();
    const MultiblockGrid grid = assembled(built);
    CHECK(grid.interfaces.size() == 3);
    CHECK(grid.patches.size() == 8);
    check_sound(grid);
}

TEST_CASE("a 2 by 2 H-grid of faces is joined along four edges") {
    HandBuilt built;
    std::vector<int> v;
    v.reserve(9);
    for (int n = 0; n < 9; ++n) {
        const int row = n / 3;
        v.push_back(built.vertex({n % 3 + 0.1 * row, static_cast<double>(row), 0}));
    }
    for (const std::size_t n : {0U, 1U, 3U, 4U}) {
        built.quadrilateral({v[n], v[n + 1], v[n + 4], v[n + 3]}, 4, 4);
    }
    built.bound_the_rest();
    const MultiblockGrid grid = assembled(built);
    CHECK(grid.interfaces.size() == 4);
    CHECK(grid.patches.size() == 8);
    check_sound(grid);
}

TEST_CASE("a ring-shaped block that uses one face twice has a cut within its zone") {
    HandBuilt built;
    const int a0 = built.vertex({1, 0, 0}), b0 = built.vertex({2, 0, 0});
    const int a1 = built.vertex({1, 0, 3}), b1 = built.vertex({2, 0, 3});
    const EdgeUse ray0 = built.between(a0, b0, 4), ray1 = built.between(a1, b1, 4);
    const EdgeUse up_a = built.between(a0, a1, 6), up_b = built.between(b0, b1, 6);
    const auto ring = [&](int v, double radius, double z) {
        return EdgeUse{built.edge(v, v, circle(radius, 12, z)), false};
    };
    const EdgeUse in0 = ring(a0, 1, 0), out0 = ring(b0, 2, 0);
    const EdgeUse in1 = ring(a1, 1, 3), out1 = ring(b1, 2, 3);
    const int cut = built.face({{{up_a}, {up_b}, {ray0}, {ray1}}});
    const int inner = built.face({{{up_a}, {up_a}, {in0}, {in1}}});
    const int outer = built.face({{{up_b}, {up_b}, {out0}, {out1}}});
    const int bottom = built.face({{{ray0}, {ray0}, {in0}, {out0}}});
    const int top = built.face({{{ray1}, {ray1}, {in1}, {out1}}});
    Block block;
    block.name = "ring";
    block.extent = {13, 5, 7};
    block.solve.method = Method::algebraic;
    const std::array<int, 6> faces{cut, cut, inner, outer, bottom, top};
    for (std::size_t s = 0; s < 6; ++s) block.sides[s].faces[0].face = faces[s];
    built.topology.blocks.push_back(block);
    built.topology.planar = false;
    built.bound_the_rest();
    const MultiblockGrid grid = assembled(built);
    REQUIRE(grid.interfaces.size() == 1);
    CHECK(grid.interfaces[0].orientation == Orientation{});
    CHECK(grid.interfaces[0].donor_box == IndexBox{{12, 0, 0}, {12, 4, 6}});
    CHECK(grid.patches.size() == 4);
    check_sound(grid);
}

TEST_CASE("faces in space are a surface grid: cells of dimension 2 in 3 dimensions") {
    HandBuilt built;
    built.topology.planar = false;
    const int a = built.vertex({0, 0, 0}), b = built.vertex({1, 0, 0.3});
    const int c = built.vertex({1, 1, 0}), d = built.vertex({0, 1, 0.2});
    built.quadrilateral({a, b, c, d}, 3, 4);
    built.bound_the_rest();
    const MultiblockGrid grid = assembled(built);
    CHECK(grid.cell_dimension == 2);
    CHECK(grid.physical_dimension == 3);
    check_sound(grid);
}

TEST_CASE("names longer than CGNS allows are shortened and stay unique and the same every time") {
    HandBuilt built;
    std::vector<int> v;
    v.reserve(6);
    for (int n = 0; n < 6; ++n) {
        const int row = n / 3;
        v.push_back(built.vertex({static_cast<double>(n % 3), static_cast<double>(row), 0}));
    }
    built.quadrilateral({v[0], v[1], v[4], v[3]}, 2, 2);
    built.quadrilateral({v[1], v[2], v[5], v[4]}, 2, 2);
    const std::string stem = "a_name_much_longer_than_thirty-two_bytes_";
    for (std::size_t n = 0; n < built.topology.edges.size(); ++n) {
        built.topology.edges[n].name = stem + std::string(n, 'x');
    }
    built.bound_the_rest();
    const MultiblockGrid grid = assembled(built);
    std::set<std::string> names;
    for (const auto& patch : grid.patches) names.insert(patch.name);
    for (const auto& interface : grid.interfaces) names.insert(interface.name);
    CHECK(names.size() == 7);
    for (const std::string& name : names) {
        CHECK(name.size() == 32);
        CHECK(name.substr(0, 23) == stem.substr(0, 23));
    }
    CHECK(assembled(built).patches[3].name == grid.patches[3].name);
}
