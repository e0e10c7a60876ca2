// SPDX-License-Identifier: Apache-2.0
// Resolving: edges collapsed to a vertex, faces collapsed to an edge or a vertex.
#include <catch2/catch.hpp>
#include <string>

#include "topology/boundaries.h"
#include "topology/resolve_helpers.h"

using namespace hexweave;

namespace {

/// A quarter of a disc; `pole` is what is said of the edge at its centre, `more` of the face.
std::string sector(const std::string& pole, const std::string& more = "",
                   const std::string& boundaries = "wall: {type: BCWall, sides: [arc, ra, rb]}") {
    return R"(
vertices: {c: [0, 0], a: [1, 0], b: [0, 1]}
curves: {rim: {circle: {center: [0, 0], radius: 1}}}
edges:
  pole: )" +
           pole +
           R"(
  arc: {from: a, to: b, along: rim, through: [0.7, 0.7], cells: 6}
  ra: {from: c, to: a, cells: 5, spacing: {law: geometric, ratio: 1.2}}
  rb: {from: c, to: b}
faces:
  f: {imin: pole, imax: arc, jmin: ra, jmax: rb)" +
           more + R"(}
boundaries:
  )" + boundaries +
           "\n";
}

/// A half cylinder collapsed to its axis: imin of the block is the face `centre`.
std::string half_cylinder(const std::string& imin = "centre") {
    return R"(
curves:
  rim0: {circle: {center: [0, 0], radius: 1}}
  rim1: {of: rim0, translate: [0, 0, 3]}
vertices: {o0: [0, 0, 0], a0: [1, 0, 0], b0: [-1, 0, 0], o1: [0, 0, 3], a1: [1, 0, 3], b1: [-1, 0, 3]}
edges:
  pole0: {at: o0}
  pole1: {at: o1, cells: 12}
  axis: {from: o0, to: o1, cells: 6}
  side_a: {from: a0, to: a1}
  side_b: {from: b0, to: b1}
  ray_a0: {from: o0, to: a0, cells: 8}
  ray_a1: {from: o1, to: a1}
  ray_b0: {from: o0, to: b0}
  ray_b1: {from: o1, to: b1}
  arc0: {from: a0, to: b0, along: rim0, through: [0, 1]}
  arc1: {from: a1, to: b1, along: rim1, through: [0, 1, 3]}
faces:
  cut_a: {imin: axis, imax: side_a, jmin: ray_a0, jmax: ray_a1}
  cut_b: {imin: axis, imax: side_b, jmin: ray_b0, jmax: ray_b1}
  disc0: {imin: pole0, imax: arc0, jmin: ray_a0, jmax: ray_b0}
  disc1: {imin: pole1, imax: arc1, jmin: ray_a1, jmax: ray_b1}
  wall: {imin: side_a, imax: side_b, jmin: arc0, jmax: arc1, method: algebraic}
  centre: {imin: axis, imax: axis, jmin: pole0, jmax: pole1}
blocks:
  b: {imin: )" +
           imin +
           R"(, imax: wall, jmin: cut_a, jmax: cut_b, kmin: disc0, kmax: disc1}
boundaries:
  all: {type: BCWall, sides: [wall, disc0, disc1, cut_a, cut_b]}
)";
}

}  // namespace

TEST_CASE("A pole takes its cells from the edge across the face, and no spacing") {
    const Topology t = resolved(sector("{at: c}"));
    CHECK(broken_promise(t) == "");
    const Edge& pole = named(t.edges, "pole");
    CHECK(pole.pole);
    CHECK(pole.cells == 6);
    CHECK(pole.length == 0);
    CHECK(vertex_name(t, pole.start) == "c");
    CHECK(pole.start == pole.end);
    CHECK(law_text(t, pole) == "own");
    CHECK_FALSE(t.faces[0].is_collapsed());
    CHECK(law_text(t, named(t.edges, "rb")) == "same as ra");
}

TEST_CASE("A pole that no boundary names has a family of its own; it may have another") {
    const Topology t = resolved(sector("{at: c}"));
    REQUIRE(t.boundaries.size() == 2);
    CHECK(t.boundaries[1].family.name == point_family);
    CHECK(t.boundaries[1].family.type == "BCDegeneratePoint");
    const Topology claimed =
        resolved(sector("{at: c}", "", "wall: {type: BCWall, sides: [arc, ra, rb, pole]}"));
    CHECK(claimed.boundaries.size() == 1);
    const Topology block = resolved(half_cylinder());
    REQUIRE(block.boundaries.size() == 2);
    CHECK(block.boundaries[1].family.name == line_family);
    CHECK(block.boundaries[1].family.type == "BCDegenerateLine");
    CHECK(faults(sector("{at: c}", "", "pole_point: {type: BCWall, sides: [arc, ra, rb]}")) ==
          R"(12: error: 'pole_point' is the family of the poles that no boundary names
  hint: give this boundary another name
)");
}

TEST_CASE("A face between two poles and one line is that line, in one orientation") {
    for (const std::string imin :
         {"centre", "{face: centre, axes: [i, j]}", "{face: centre, axes: [-i, j]}"}) {
        const Topology t = resolved(half_cylinder(imin));
        CHECK(broken_promise(t) == "");
        const Face& centre = named(t.faces, "centre");
        CHECK(centre.collapsed == std::array{true, false});
        CHECK(t.blocks[0].extent == Extent{9, 13, 7});
        CHECK(centre.extent() == Extent{13, 7, 1});
    }
    CHECK(faults(half_cylinder("{face: centre, axes: [j, i]}")) ==
          R"(26: error: 'axes: [j, i]' of 'centre' (imin) contradict the edges of block 'b'
  hint: the edges ask for 'axes: [i, j]'
)");
}

TEST_CASE("What cannot be said of a pole is refused") {
    CHECK(faults(sector("{at: c, spacing: uniform}")) ==
          "5: error: a pole, an edge that is one vertex, has no spacing\n");
    CHECK(faults(sector("{at: d}")) ==
          "5: error: unknown vertex 'd'\n  hint: known: 'a', 'b' and 'c'\n");
    CHECK(first_error(sector("{at: c, from: a, to: b}")) ==
          R"(5: error: an edge is a pole 'at' a vertex, or goes 'from' one 'to' another
  hint: leave out 'at', or 'from' and 'to'
)");
    CHECK(faults(sector("{at: c}", ", orthogonal: [imin, imax]")) ==
          R"(10: error: imin of face 'f' is a pole: no grid lines can meet it at right angles
  hint: take imin out of 'orthogonal'
)");
    CHECK(faults(sector("{at: c}", ", heights: {imin: held}")) ==
          R"(10: error: imin of face 'f' is a pole: no heights can be held there
  hint: take imin out of 'heights'
)");
    CHECK(faults(sector("{at: c, cells: 7}")) ==
          R"(6: error: edge 'arc' has 6 cells, but edge 'pole', parallel to it, has 7 cells
  10: across face 'f', 'pole' has as many cells as 'arc'
  5: 'pole' has 7 cells
  hint: parallel edges have equally many cells: give 'cells' to one of them
)");
}

TEST_CASE("Two faces do not join at a pole") {
    std::string text = sector("{at: c}");
    const std::string face = "  f: {imin: pole, imax: arc, jmin: ra, jmax: rb}\n";
    text.replace(text.find(face), face.size(),
                 face + "  g: {imin: pole, imax: arc2, jmin: rb, jmax: rd}\n");
    const std::string edge = "  rb: {from: c, to: b}\n";
    text.replace(text.find(edge), edge.size(),
                 edge +
                     "  rd: {from: c, to: d}\n"
                     "  arc2: {from: b, to: d, along: rim, through: [-0.7, 0.7]}\n");
    text.replace(text.find("b: [0, 1]"), 9, "b: [0, 1], d: [-1, 0]");
    CHECK(first_error(text) ==
          R"(5: error: edge 'pole' is collapsed and cannot join faces 'f' and 'g'
  hint: give each face one of its own
)");
}
