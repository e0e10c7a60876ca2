// SPDX-License-Identifier: Apache-2.0
// Components, instances, ports and repetition. What can be wrong with them is in tests/cases/bad.
#include "topology/instances.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/errors.h"
#include "topology/read_case.h"
#include "topology/resolve.h"

using namespace hexweave;

namespace {

const std::string strip = R"(hexweave: 1
components:
  strip:
    parameters: {length: 1, cells: required, wall: length / 100}
    ports: {left: west, right: east, field: field}
    curves: {bump: {formula: [length * t, 0.1 * t * (1 - t)], range: [0, 1]}}
    vertices: {a: [0, 0], b: [length, 0], c: [length, 1], d: [0, 1]}
    edges:
      south: {from: a, to: b, along: bump, cells: cells}
      north: {from: d, to: c}
      west: {from: a, to: d, spacing: {start: wall}}
      east: {from: b, to: c, cells: 8}
    faces:
      field: {imin: west, imax: east, jmin: south, jmax: north}
    boundaries:
      floor: {type: BCWall, sides: south}
      roof: {type: BCFarfield, sides: north}
)";

Case read(const std::string& lines, Diagnostics& diagnostics) {
    const auto source = std::make_shared<const SourceFile>(SourceFile{"case.yaml", strip + lines});
    return read_case(source, {}, diagnostics);
}

Topology resolved(const std::string& lines) {
    Diagnostics diagnostics;
    try {
        return resolve(read(lines, diagnostics), diagnostics);
    } catch (const InputError& e) {
        FAIL(render(e.diagnostics));
        throw;
    }
}

template <class Entity>
const Entity& named(const std::vector<Entity>& entities, const std::string& name) {
    const auto found = std::find_if(entities.begin(), entities.end(),
                                    [&](const Entity& e) { return e.name == name; });
    INFO(name);
    REQUIRE(found != entities.end());
    return *found;
}

template <class Entity>
bool has(const std::vector<Entity>& entities, const std::string& name) {
    return std::any_of(entities.begin(), entities.end(),
                       [&](const Entity& e) { return e.name == name; });
}

}  // namespace

TEST_CASE("an instance is moved, and its lengths are scaled with it") {
    const Topology t = resolved(
        "instances: {main: {of: strip, set: {cells: 10, length: 2}, transform: [{scale: 0.5}, "
        "{rotate: pi / 2}, {translate: [3, 0]}]}}");
    const Vec3 b = named(t.vertices, "main.b").position;
    CHECK(b.x == Approx(3));
    CHECK(b.y == Approx(1));
    const auto& law = std::get<TanhLaw>(named(t.edges, "main.west").law);
    CHECK(*law.start == Approx(0.01));
    const Edge& south = named(t.edges, "main.south");
    CHECK(evaluate(*south.curve, 0.5).x == Approx(3 - 0.5 * 0.025));
    CHECK(south.cells == 10);
}

TEST_CASE(
    "a joined port is the edge outside, whose cells and law it gives where they are lacking") {
    const Topology t = resolved(
        "instances:\n"
        "  main: {of: strip, set: {cells: 10}}\n"
        "  tail: {of: strip, set: {cells: 20, length: 2}, translate: [1, 0], join: {left: "
        "main.right}}\n");
    CHECK(t.faces.size() == 2);
    CHECK(t.edges.size() == 7);
    CHECK(t.vertices.size() == 6);
    CHECK_FALSE(has(t.edges, "tail.west"));
    CHECK_FALSE(has(t.vertices, "tail.a"));
    const Face& tail = named(t.faces, "tail.field");
    CHECK(t.edges[static_cast<std::size_t>(tail.side(Side::imin)[0].edge)].name == "main.east");
    CHECK(*std::get<TanhLaw>(named(t.edges, "main.east").law).start == Approx(0.02));
}

TEST_CASE("a mirrored instance stays right-handed, its walls where they were") {
    const Topology t = resolved(
        "instances:\n"
        "  main: {of: strip, set: {cells: 10}}\n"
        "  image: {of: strip, set: {cells: 10}, mirror: {normal: [1, 0]}, join: {left: "
        "main.left}}\n");
    const Face& image = named(t.faces, "image.field");
    CHECK(t.edges[static_cast<std::size_t>(image.side(Side::imax)[0].edge)].name == "main.west");
    CHECK(t.edges[static_cast<std::size_t>(image.side(Side::jmin)[0].edge)].name == "image.south");
    CHECK(named(t.vertices, "image.b").position.x == -1);
}

TEST_CASE("families of one name are one, unless an instance has its own") {
    const Topology t = resolved(
        "instances:\n"
        "  low: {of: strip, set: {cells: 10}}\n"
        "  high: {of: strip, set: {cells: 10}, translate: [5, 0]}\n"
        "  own: {of: strip, set: {cells: 10}, translate: [9, 0], families: own}\n");
    const auto sides_of = [&](const std::string& family) {
        for (const Boundary& boundary : t.boundaries) {
            if (boundary.family.name == family) return boundary.sides.size();
        }
        return std::size_t{0};
    };
    CHECK(sides_of("floor") == 2);
    CHECK(sides_of("own.floor") == 1);
}

TEST_CASE("a row of repeated instances, each joined to the one before") {
    const Topology t = resolved(
        "parameters: {count: 4}\n"
        "instances:\n"
        "  cell{i}:\n"
        "    of: strip\n"
        "    repeat: {i: [1, count]}\n"
        "    set: {cells: 4 * i}\n"
        "    translate: [i, 0]\n"
        "    join: {left: {to: \"cell{i - 1}.right\", when: i > 1}}\n"
        "boundaries: {ends: {type: BCOutflow, sides: [cell1.left, cell4.right]}}\n");
    CHECK(t.faces.size() == 4);
    CHECK(t.edges.size() == 13);
    CHECK(named(t.edges, "cell3.south").cells == 12);
    CHECK(named(t.vertices, "cell4.b").position.x == 5);
}

TEST_CASE("components are made of components, with qualified names") {
    const Topology t = resolved(
        "  pair:\n"
        "    parameters: {count: 6}\n"
        "    ports: {end: second.right}\n"
        "    instances:\n"
        "      first: {of: strip, set: {cells: count}}\n"
        "      second: {of: strip, set: {cells: count}, translate: [1, 0], join: {left: "
        "first.right}}\n"
        "instances:\n"
        "  low: {of: pair, scale: 2}\n"
        "  next:\n"
        "    of: strip\n"
        "    set: {cells: 3}\n"
        "    transform: [{scale: 2}, {translate: [4, 0]}]\n"
        "    join: {left: low.end}\n");
    CHECK(named(t.vertices, "low.second.c").position == Vec3{4, 2, 0});
    CHECK(named(t.edges, "low.second.south").cells == 6);
    const Face& next = named(t.faces, "next.field");
    CHECK(t.edges[static_cast<std::size_t>(next.side(Side::imin)[0].edge)].name ==
          "low.second.east");
}

TEST_CASE("a fault of a component shows the line that uses it") {
    Diagnostics diagnostics;
    read(
        "    solver: 3\n  worse:\n    vertices: {a: [unknown, 0]}\n"
        "instances:\n  one: {of: worse}\n",
        diagnostics);
    const std::string text = render(diagnostics);
    INFO(text);
    CHECK(text.find("case.yaml:20:20: error: unknown parameter 'unknown'") != std::string::npos);
    CHECK(text.find("case.yaml:22:3: note: in instance 'one', written here") != std::string::npos);
}

TEST_CASE("what an instance of an unknown component would have is not told besides") {
    Diagnostics diagnostics;
    try {
        resolve(read(R"(instances:
  one: {of: strip, set: {cells: 4}}
  two: {of: stripe, set: {cells: 4}}
edges:
  across: {from: one.b, to: two.a, cells: 3}
faces:
  between: {imin: one.east, imax: two.west, jmin: across, jmax: one.c-two.d}
  other: {corners: [one.b, two.a, two.d, one.c]}
boundaries:
  more: {type: BCWall, sides: [across, two.east]}
)",
                     diagnostics),
                diagnostics);
    } catch (const InputError&) {
        REQUIRE(diagnostics.all().size() == 1);
        CHECK(diagnostics.all()[0].message == "unknown component 'stripe'");
        CHECK(diagnostics.all()[0].hint == "did you mean 'strip'?");
    }
    CHECK(diagnostics.has_errors());
}
