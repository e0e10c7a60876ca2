// SPDX-License-Identifier: Apache-2.0
// Resolving: what is said of edges that are not where they should be.
#include <catch2/catch.hpp>
#include <cmath>

#include "topology/curve_pieces.h"
#include "topology/draft.h"
#include "topology/resolve_helpers.h"

using namespace hexweave;

namespace {

/// What is said of an edge among some curves and vertices.
std::string fault_of_edge(const std::string& edge) {
    const std::string shapes = R"(
curves:
  circle: {circle: {center: [0, 0], radius: 1}}
  line: {line: [[0, 0], [1, 0]]}
vertices: {e: [1, 0], top: [0, 1], w: [-1, 0], away: [1.5, 0], o: [0, 0], o2: [0, 0], mid: [0.5, 0]}
edges:
  x: )";
    return first_error(shapes + edge + "\n");
}

}  // namespace

TEST_CASE("On a closed curve two ways lead from one vertex to another") {
    CHECK(fault_of_edge("{from: e, to: w, along: circle}") ==
          R"(7: error: two ways lead from 'e' to 'w' along 'circle', a closed curve
  hint: pick one by a point on it: 'through: [0, 1]' or 'through: [0, -1]'
)");
}

TEST_CASE("A vertex must be on the curve") {
    CHECK(fault_of_edge("{from: away, to: w, along: circle, through: [0, 1]}") ==
          R"(7: error: vertex 'away' is not on the curve 'circle': it is 0.5 away
  hint: the nearest point of the curve is {curve: circle, at: 0}, at [1, 0]
)");
}

TEST_CASE("A loop takes no 'through'") {
    CHECK(fault_of_edge("{from: e, to: e, along: circle, through: [0, 1]}") ==
          R"(7: error: 'through' picks nothing: edge 'x' runs once round 'circle'
  hint: leave 'through' out
)");
}

TEST_CASE("On an open curve 'through' must lie between") {
    CHECK(fault_of_edge("{from: o, to: mid, along: line, through: [0.75, 0]}") ==
          R"(7: error: 'through' does not lie between 'o' and 'mid' on the curve 'line'
  hint: give a point of the curve between the two
)");
}

TEST_CASE("An open curve has no loop") {
    CHECK(fault_of_edge("{from: o, to: o, along: line}") ==
          R"(7: error: edge 'x' goes from 'o' to itself, but 'line' is not a closed curve
  hint: name two vertices, or a closed curve
)");
}

TEST_CASE("A straight edge joins two places") {
    CHECK(fault_of_edge("{from: o, to: o2}") ==
          R"(7: error: edge 'x' has no length: 'o' and 'o2' are the same place
  hint: name one vertex in both places, or move one; an edge that is one point is a pole, {at: VERTEX}
)");
}

TEST_CASE("A straight edge joins two vertices") {
    CHECK(fault_of_edge("{from: o, to: o}") ==
          R"(7: error: edge 'x' goes from 'o' to itself in a straight line
  hint: name the closed curve that it follows with 'along'
)");
}

TEST_CASE("A straight edge takes no 'through'") {
    CHECK(fault_of_edge("{from: o, to: e, through: [0, 1]}") ==
          R"(7: error: 'through' picks a way along a closed curve, but edge 'x' is a straight line
  hint: name the curve with 'along', or leave 'through' out
)");
}

TEST_CASE("An edge has a length on its curve too") {
    CHECK(fault_of_edge("{from: o, to: o2, along: line}") ==
          R"(7: error: edge 'x' has no length: 'o' and 'o2' are the same place on 'line'
  hint: name two different vertices; an edge that is one point is a pole, {at: VERTEX}
)");
}

TEST_CASE("'through' picks the way along a closed curve, over its seam too") {
    const std::string text = R"(
curves:
  circle: {circle: {center: [0, 0], radius: 1}}
vertices: {e: {curve: circle, at: 0}, s: {curve: circle, at: 0.75}, w: [-1, 0], o: [0, 0]}
edges:
  far:  {from: s, to: e, along: circle, through: [0, 1], cells: 4}
  near: {from: e, to: s, along: circle, through: [0.7, -0.7], cells: 4}
  wo:   {from: w, to: o, cells: 4}
  low:  {from: w, to: s, along: circle, through: [-0.5, -0.5]}
faces:
  f: {corners: [w, s, e, o]}
  g: {imin: low, imax: far, jmin: wo, jmax: near}
)";
    Diagnostics diagnostics;
    const auto source =
        std::make_shared<const SourceFile>(SourceFile{"t.yaml", "hexweave: 1\n" + text});
    const Case c = read_case(source, {}, diagnostics);
    Draft draft(c, diagnostics);
    place_vertices(draft);
    place_edges(draft);
    const double quarter = std::acos(-1.0) / 2;
    CHECK(draft.edges[0].edge.length == Approx(3 * quarter).epsilon(1e-12));
    CHECK(draft.edges[0].edge.to < draft.edges[0].edge.from);
    CHECK(draft.edges[1].edge.length == Approx(quarter).epsilon(1e-12));
    CHECK(draft.edges[3].edge.length == Approx(quarter).epsilon(1e-12));
    CHECK(draft.edges[3].edge.to > draft.edges[3].edge.from);
}

TEST_CASE("An open curve whose ends meet leads two ways from there") {
    Curve drop;  // from the origin and back to it
    drop.position = [](double t) { return Vec3{t * (1 - t), t * (1 - t) * (1 - 2 * t), 0}; };
    drop.derivative = [](double t) { return Vec3{1 - 2 * t, 1 - 6 * t + 6 * t * t, 0}; };
    CHECK(passings(drop, 0) == std::vector<double>{0, 1});
    CHECK(passings(drop, 0.25) == std::vector<double>{0.25});
    const auto pieces = pieces_between(drop, {0, 1}, {0.25}, false);
    REQUIRE(pieces.size() == 2);
    CHECK(passes(drop, pieces[0], 0.1));
    CHECK_FALSE(passes(drop, pieces[0], 0.9));
    CHECK(passes(drop, pieces[1], 0.9));
    CHECK(pieces_between(drop, {0, 1}, {0, 1}, true).size() == 1);
}
