// SPDX-License-Identifier: Apache-2.0
#include "edges/edge_grid.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/parallel.h"
#include "geometry/conics.h"
#include "geometry/formula.h"
#include "geometry/lines.h"
#include "geometry/naca.h"
#include "geometry/transform.h"

using namespace hexweave;

namespace {

constexpr double pi = std::numbers::pi;

/// A topology of edges alone, each along a curve of its own.
class Edges {
public:
    /// Adds an edge between two parameters; its vertices are the points there.
    Edge& add(const Curve& curve, double from, double to, int cells, SpacingLaw law) {
        Edge edge;
        edge.curve = std::make_shared<const Curve>(curve);
        edge.from = from;
        edge.to = to;
        edge.cells = cells;
        edge.law = std::move(law);
        edge.start = add_vertex(evaluate(curve, from));
        edge.end = add_vertex(evaluate(curve, to));
        edge.length = arc_length(curve, from, to);
        topology.edges.push_back(edge);
        return topology.edges.back();
    }

    Topology topology;

private:
    int add_vertex(const Vec3& position) {
        topology.vertices.push_back({"", position, {}});
        return static_cast<int>(topology.vertices.size()) - 1;
    }
};

/// A curved line of length 20 or so: a spiral arm.
Curve spiral() {
    return formula(
        [](double t) {
            return Vec3{(1 + 2 * t) * std::cos(t), (1 + 2 * t) * std::sin(t), 0.3 * t * t};
        },
        0, 4);
}

/// The length between two parameters by the composite Simpson rule on chords of the position: no
/// derivative, no table.
double chord_length(const Curve& curve, double a, double b) {
    const auto chords = [&](int count) {
        double sum = 0;
        for (int k = 0; k < count; ++k) {
            sum += distance(evaluate(curve, a + (b - a) * k / count),
                            evaluate(curve, a + (b - a) * (k + 1) / count));
        }
        return sum;
    };
    return (4 * chords(2) - chords(1)) / 3;  // Richardson: chords err with the second order
}

}  // namespace

TEST_CASE("a first cell of 1e-5 on a long curved edge is met to 1e-6") {
    Edges edges;
    const Edge edge = edges.add(spiral(), 0, 4, 96, TanhLaw{1e-5, 0.7});
    CHECK(edge.length > 15);
    const EdgeGrid grid = make_edges(edges.topology).at(0);
    CHECK(first_cell(edge, grid) == Approx(1e-5).epsilon(1e-9));
    CHECK(last_cell(edge, grid) == Approx(0.7).epsilon(1e-9));
    CHECK(chord_length(*edge.curve, grid.parameters[0], grid.parameters[1]) ==
          Approx(1e-5).epsilon(1e-6));
    CHECK(distance(grid.points[0], grid.points[1]) == Approx(1e-5).epsilon(1e-6));
}

TEST_CASE("small cells at the trailing edge of an airfoil are met to 1e-6") {
    Edges edges;
    const Curve lower =
        naca_airfoil("2412", 1, AirfoilSide::lower, TrailingEdge::sharp).curve.value();
    const Edge there = edges.add(lower, 0, 1, 64, TanhLaw{1e-5, 1e-6});
    const Edge back = edges.add(lower, 1, 0, 64, TanhLaw{1e-6, 1e-5});
    const std::vector<EdgeGrid> grids = make_edges(edges.topology);
    CHECK(first_cell(there, grids[0]) == Approx(1e-5).epsilon(1e-9));
    CHECK(last_cell(there, grids[0]) == Approx(1e-6).epsilon(1e-9));
    CHECK(first_cell(back, grids[1]) == Approx(1e-6).epsilon(1e-9));
    CHECK(last_cell(back, grids[1]) == Approx(1e-5).epsilon(1e-9));
}

TEST_CASE("end points are the vertices to the bit, wherever the curve ends") {
    Edges edges;
    edges.add(circle({0.1, 0.2, 0}, 3), 0.3, 2.9, 8, UniformLaw{});
    Vec3& moved = edges.topology.vertices[1].position;
    moved.x += 1e-12;
    const Vec3 vertex = moved;
    const EdgeGrid grid = make_edges(edges.topology).at(0);
    CHECK(grid.points.size() == 9);
    CHECK(grid.points.back() == vertex);
    CHECK(grid.points.front() == edges.topology.vertices[0].position);
    CHECK(grid.parameters.front() == 0.3);
    CHECK(grid.parameters.back() == 2.9);
}

TEST_CASE("uniform points on a circle divide its angle, across the seam too") {
    Edges edges;
    edges.add(circle({}, 2), 3.5, 4.5, 6, UniformLaw{});
    const EdgeGrid grid = make_edges(edges.topology).at(0);
    for (int i = 0; i <= 6; ++i) {
        const double angle = -pi / 4 + i * pi / 12;
        const Vec3 p = grid.points[static_cast<std::size_t>(i)];
        CHECK(distance(p, {2 * std::cos(angle), 2 * std::sin(angle), 0}) < 1e-14);
    }
}

TEST_CASE("the same spacing is handed on along chains, reversed as often as they say") {
    Edges edges;
    const Curve line = straight_line({0, 0, 0}, {3, 0, 0});
    edges.add(line, 0, 1, 10, SameAs{1, true});
    edges.add(circle({}, 5), 0, 1, 10, SameAs{2, false});
    edges.add(line, 0, 1, 10, TanhLaw{1e-3, 0.5});
    edges.add(line, 1, 0, 10, SameAs{0, true});
    const std::vector<EdgeGrid> grids = make_edges(edges.topology);
    CHECK(grids[1].fractions == grids[2].fractions);
    for (std::size_t i = 0; i <= 10; ++i) {
        CHECK(grids[0].fractions[i] == Approx(1 - grids[2].fractions[10 - i]).margin(1e-16));
        CHECK(grids[3].fractions[i] == Approx(grids[2].fractions[i]).margin(2e-16));
    }
    CHECK(grids[2].fractions[1] * 3 == Approx(1e-3).epsilon(1e-12));
}

TEST_CASE("explicit fractions of the parameter place points there") {
    Edges edges;
    ExplicitLaw law;
    law.values = {0, 0.25, 0.5, 1};
    law.of_parameter = true;
    const Curve curve = spiral();
    edges.add(curve, 1, 3, 3, law);
    edges.add(straight_line({0, 0, 0}, {1, 0, 0}), 0, 1, 3, SameAs{0, false});
    const std::vector<EdgeGrid> grids = make_edges(edges.topology);
    CHECK(grids[0].parameters[1] == Approx(1.5).epsilon(1e-12));
    CHECK(grids[0].parameters[2] == Approx(2).epsilon(1e-12));
    CHECK(grids[0].fractions[1] ==
          Approx(arc_length(curve, 1, 1.5) / arc_length(curve, 1, 3)).epsilon(1e-12));
    CHECK(grids[1].fractions == grids[0].fractions);
}

TEST_CASE("points on a symmetry plane and of a planar topology are exactly there") {
    Edges edges;
    const Curve tilted = transformed(circle({}, 1), rotation({1, 0, 0}, 1e-13));
    edges.add(tilted, 0.5, 1.5, 12, UniformLaw{});
    edges
        .add(transformed(straight_line({0, 0, 0}, {1, 1, 1}), scaling({1e-13, 1, 1})), 0, 1, 5,
             UniformLaw{})
        .planes = {{0, 0.0}};
    edges.topology.planar = false;
    const std::vector<EdgeGrid> grids = make_edges(edges.topology);
    CHECK(grids[0].points[6].z != 0);
    for (std::size_t i = 1; i < 5; ++i) {
        CHECK(grids[1].points[i].x == 0);
        CHECK(grids[1].points[i].z > 0);
    }
    edges.topology.planar = true;
    for (std::size_t i = 1; i < 12; ++i) {
        CHECK(make_edges(edges.topology)[0].points[i].z == 0);
    }
}

TEST_CASE("edges do not depend on the number of threads") {
    Edges edges;
    for (int k = 0; k < 12; ++k) {
        edges.add(spiral(), 0.1 * k, 4, 30,
                  k % 3 == 2 ? SpacingLaw{SameAs{k - 1, true}} : SpacingLaw{TanhLaw{1e-4, 0.2}});
    }
    const int before = threads();
    set_threads(1);
    const std::vector<EdgeGrid> one = make_edges(edges.topology);
    set_threads(4);
    const std::vector<EdgeGrid> four = make_edges(edges.topology);
    set_threads(before);
    for (std::size_t e = 0; e < one.size(); ++e) {
        CHECK(one[e].points == four[e].points);
        CHECK(one[e].parameters == four[e].parameters);
    }
}
