// SPDX-License-Identifier: Apache-2.0
// Periodic interfaces: pairs, directions, counts, laws, places, and all that may be wrong.
#include <catch2/catch.hpp>
#include <string>

#include "core/periodic_image.h"
#include "topology/periodic_links.h"
#include "topology/resolve_helpers.h"

using namespace hexweave;
using Catch::Matchers::Contains;

namespace {

/// A channel of two faces whose lower and upper sides are images; `up2` runs against `low2`.
std::string channel(const std::string& upper_edges, const std::string& periodic,
                    const std::string& more = "") {
    return R"(vertices:
  a: [0, 0.1]
  b: [2, 0.4]
  c: [2, 1.1]
  d: [0, 0.8]
  p: [1, 0.1]
  q: [1, 0.8]
curves:
  low: {spline: [[0, 0.1], [0.5, 0.4], [1, 0.1], [1.5, 0], [2, 0.4]]}
  high: {of: low, translate: [0, 0.7]}
edges:
  low1: {from: a, to: p, along: low, cells: 12, spacing: {start: 0.02}}
  low2: {from: p, to: b, along: low, cells: 10}
)" + upper_edges +
           R"(
  inlet: {from: a, to: d, cells: 16}
  middle: {from: p, to: q}
  outlet: {from: b, to: c}
faces:
  first: {imin: inlet, imax: middle, jmin: low1, jmax: up1}
  second: {imin: middle, imax: outlet, jmin: low2, jmax: up2}
periodic:
)" + periodic +
           "\nboundaries:\n  ends: {type: BCInflow, sides: [inlet, outlet" + more + "]}\n";
}

const std::string upper =
    "  up1: {from: d, to: q, along: high}\n"
    "  up2: {from: c, to: q, along: high}";
const std::string pitch = "  pitch: {from: [low1, low2], to: [up2, up1], translate: [0, 0.7]}";

/// A box whose corners are given; the faces between them are made.
std::string box(const std::string& periodic, const std::string& boundaries,
                const std::string& g = "[1.4, 1.8, 3]") {
    return R"(vertices:
  a: [1.1, 1.1, 2]
  b: [1.4, 1.1, 2]
  c: [1.4, 1.8, 2]
  d: [1.1, 1.8, 2]
  e: [1.1, 1.1, 3]
  f: [1.4, 1.1, 3]
  g: )" + g +
           R"(
  h: [1.1, 1.8, 3]
edges:
  ab: {from: a, to: b, cells: 3}
  ad: {from: a, to: d, cells: 4, spacing: {start: 0.1}}
  ae: {from: a, to: e, cells: 5}
blocks: {box: {corners: [a, b, c, d, e, f, g, h]}}
periodic:
)" + periodic +
           "\nboundaries:\n  wall: {type: BCWall, sides: [" + boundaries + "]}\n";
}

Vec3 position(const Topology& t, const std::string& vertex) {
    return named(t.vertices, vertex).position;
}

}  // namespace

TEST_CASE("sides are paired by where they are, whatever their order and direction") {
    const Topology t = resolved(channel(upper, pitch));
    REQUIRE(t.periodic.size() == 1);
    const PeriodicInterface& interface = t.periodic[0];
    REQUIRE(interface.pairs.size() == 2);
    CHECK(edge_name(t, interface.pairs[0].from) == "low1");
    CHECK(edge_name(t, interface.pairs[0].to) == "up1");
    CHECK(interface.pairs[0].orientation == Orientation{});
    CHECK(edge_name(t, interface.pairs[1].to) == "up2");
    CHECK(interface.pairs[1].orientation.axes[0] == -1);
    CHECK(t.boundaries.size() == 1);
    CHECK(broken_promise(t).empty());
}

TEST_CASE("counts and laws pass to images, and back from them") {
    const Topology there = resolved(channel(upper, pitch));
    CHECK(named(there.edges, "up1").cells == 12);
    CHECK(law_text(there, named(there.edges, "up1")) == "same as low1");
    CHECK(law_text(there, named(there.edges, "up2")) == "same as -low2");

    std::string text = channel(upper, pitch);
    const std::string own = ", cells: 12, spacing: {start: 0.02}";
    text.erase(text.find(own), own.size());
    text.insert(text.find("along: high") + 11, own);
    const Topology back = resolved(text);
    CHECK(named(back.edges, "low1").cells == 12);
    CHECK(law_text(back, named(back.edges, "low1")) == "same as up1");
    CHECK(law_text(back, named(back.edges, "up1")) == "own");
}

TEST_CASE("vertices of images are exactly there") {
    const Topology t = resolved(channel(upper, pitch));
    const PeriodicMap map = periodic_map(t.periodic[0].periodicity);
    CHECK(position(t, "d") == image(map, position(t, "a")));
    CHECK(position(t, "q") == image(map, position(t, "p")));
    CHECK(position(t, "c") == image(map, position(t, "b")));
    CHECK(position(t, "d") != Vec3{0, 0.8, 0});  // 0.1 + 0.7, in floating point
}

TEST_CASE("a side may state the law of its image, but no other one") {
    const auto stated = [](const std::string& law) {
        return channel("  up1: {from: d, to: q, along: high, spacing: " + law +
                           "}\n  up2: {from: c, to: q, along: high}",
                       pitch);
    };
    CHECK(law_text(resolved(stated("{start: 0.02}")),
                   named(resolved(stated("{start: 0.02}")).edges, "up1")) == "same as low1");
    CHECK(faults(stated("{start: 0.03}")) ==
          "14: error: edge 'up1' has another spacing than edge 'low1', whose image it is\n"
          "  12: the spacing of 'low1'\n"
          "  23: the periodic interface\n"
          "  hint: give a law to one of them only: the other one takes it over\n");
}

TEST_CASE("counts that differ are told across the interface") {
    CHECK_THAT(faults(channel("  up1: {from: d, to: q, along: high, cells: 14}\n"
                              "  up2: {from: c, to: q, along: high}",
                              pitch)),
               Contains("edge 'up1' has 14 cells, but edge 'low1', parallel to it, has 12 cells"));
}

TEST_CASE("a side that is no image is told with how far it is off") {
    CHECK_THAT(faults(box("  south: {from: a-b-f-e, to: d-c-g-h, translate: [0, 0.7, 0]}",
                          "a-b-c-d, e-f-g-h, a-d-h-e, b-c-g-f", "[1.4, 1.8, 3.1]")),
               Contains("no side of 'to' is the image of face 'a-b-f-e' by 'south': vertex 'g' is "
                        "0.1 away from the image of vertex 'f'") &&
                   Contains("hint: the image of that vertex is [1.4, 1.8, 3]"));
    CHECK_THAT(
        faults(channel("  up1: {from: d, to: q}\n  up2: {from: c, to: q, along: high}", pitch)),
        Contains("edge 'up1' is 0.3") && Contains("away from the image of edge 'low1'") &&
            Contains("let it follow the same curve, moved"));
}

TEST_CASE("a map that is wrong for all sides is told once, with the right one") {
    const auto pitched = [](const std::string& map) {
        return channel(upper, "  pitch: {from: [low1, low2], to: [up1, up2], " + map + "}");
    };
    CHECK(faults(pitched("translate: [0, 0.71]")) ==
          "23: error: the sides of 'to' are no images of those of 'from' by 'pitch': vertex 'q' is "
          "0.01 away from the image of vertex 'p'\n"
          "  hint: with 'translate: [0, 0.7]' they are\n");
    const std::string sector = R"(vertices:
  a: [1, 0, 0]
  b: [2, 0, 0]
  c: [2 * cos(pi / 7), 2 * sin(pi / 7), 0]
  d: [cos(pi / 7), sin(pi / 7), 0]
curves:
  in: {arc: {center: [0, 0], radius: 1, from: 0, to: pi / 7}}
  out: {arc: {center: [0, 0], radius: 2, from: 0, to: pi / 7}}
edges:
  low: {from: a, to: b, cells: 3}
  high: {from: d, to: c}
  in: {from: a, to: d, along: in, cells: 4}
  out: {from: b, to: c, along: out}
faces: {f: {imin: in, imax: out, jmin: low, jmax: high}}
boundaries: {ends: {type: BCInflow, sides: [in, out]}}
periodic:
)";
    CHECK_THAT(faults(sector + "  turn: {from: low, to: high, rotate: {axis: [0, 0, -1], angle: "
                               "pi / 7}}\n"),
               Contains("no images of those of 'from' by 'turn'") &&
                   Contains("hint: with 'angle: -pi / 7' they are"));
    CHECK(faults(sector + "  turn: {from: low, to: high, rotate: {axis: [0, 0, -1], angle: "
                          "-2 * pi / 14}}\n")
              .empty());
}

TEST_CASE("lists of different lengths, sides that are not free, sides named again") {
    CHECK_THAT(
        faults(channel(upper, "  pitch: {from: [low1, low2], to: up1, translate: [0, 0.7]}")),
        Contains("periodic interface 'pitch' has 2 edges in 'from', but 1 edge in 'to'"));
    CHECK_THAT(faults(channel(upper, "  pitch: {from: middle, to: up1, translate: [0, 0.7]}")),
               Contains("edge 'middle' cannot be periodic: it joins faces 'first' and 'second'"));
    CHECK_THAT(
        faults(channel(upper, pitch + "\n  again: {from: low1, to: up1, translate: [0, 0.7]}")),
        Contains("edge 'low1' cannot be periodic: it is named already"));
    CHECK_THAT(faults(channel(upper, "  pitch: {from: first, to: lo, translate: [0, 0.7]}")),
               Contains("'first' is a face, but the sides of a periodic interface are edges") &&
                   Contains("unknown edge 'lo'"));
}

TEST_CASE("a periodic side is no boundary") {
    CHECK_THAT(faults(channel(upper, pitch, ", up1")),
               Contains("edge 'up1' is no boundary: it is a side of the periodic interface "
                        "'pitch'"));
}

TEST_CASE("faces are paired in any orientation, with all that bounds them") {
    const Topology t = resolved(box("  south: {from: b-a-e-f, to: h-g-c-d, translate: [0, 0.7, 0]}",
                                    "a-b-c-d, e-f-g-h, "
                                    "a-d-h-e, b-c-g-f"));
    REQUIRE(t.periodic[0].pairs.size() == 1);
    const PeriodicPair& pair = t.periodic[0].pairs[0];
    const Face& from = t.faces[static_cast<std::size_t>(pair.from)];
    const Face& to = t.faces[static_cast<std::size_t>(pair.to)];
    // a-b-f-e: i from a to b; c-d-h-g: i from c to d, j from c to g.
    CHECK(corner_text(t, from.corners) == "a b f e");
    CHECK(corner_text(t, to.corners) == "c d h g");
    CHECK(pair.orientation == Orientation{{-1, 2, 3}});
    REQUIRE(to.image);
    CHECK(to.image->of == pair.from);
    const PeriodicMap map = periodic_map(t.periodic[0].periodicity);
    CHECK(position(t, "h") == image(map, position(t, "e")));
    CHECK(named(t.edges, "c-d").cells == 3);
    CHECK(named(t.edges, "c-d").image->reversed());
}

TEST_CASE("the corner of a doubly periodic box is one place") {
    const std::string south = "  south: {from: a-b-f-e, to: d-c-g-h, translate: [0, 0.7, 0]}\n";
    const std::string west = "  west: {from: a-d-h-e, to: b-c-g-f, translate: [0.3, 0, 0]}";
    const Topology t = resolved(box(south + west, "a-b-c-d, e-f-g-h"));
    for (const PeriodicInterface& interface : t.periodic) {
        const PeriodicMap map = periodic_map(interface.periodicity);
        const bool along_y = interface.name == "south";
        CHECK(position(t, "c") == image(map, position(t, along_y ? "b" : "d")));
        CHECK(position(t, "g") == image(map, position(t, along_y ? "f" : "h")));
    }
}

TEST_CASE("a vertex that two interfaces would have at different places is an error") {
    CHECK_THAT(faults(channel(upper,
                              "  one: {from: low1, to: up1, translate: [0, 0.7]}\n"
                              "  two: {from: low2, to: up2, translate: [0, 0.7 + 1e-10]}")),
               Contains("vertex 'q' is not exactly the image of 'p' by 'two': it is 1e-10 away, as "
                        "an image by another way") &&
                   Contains("hint: interfaces that meet must agree to round-off"));
}

TEST_CASE("an image has no surface or way of being made of its own") {
    std::string text = box("  south: {from: a-b-f-e, to: top, translate: [0, 0.7, 0]}",
                           "a-b-c-d, e-f-g-h, a-d-h-e, b-c-g-f");
    text += "faces: {top: {corners: [d, c, g, h], method: algebraic}}\n";
    CHECK_THAT(faults(text), Contains("face 'top' is the periodic image of face 'a-b-f-e' and has "
                                      "not a way of being made of its own"));
}

TEST_CASE("what is linked is made of what is no image, by inverse maps only where it must") {
    // 0 -> 1 -> 3 and 2 -> 3: 2 is reached from 3, backwards.
    const auto steps = periodic_steps({{0, 1, false, 0}, {1, 3, true, 1}, {2, 3, true, 0}}, 5);
    CHECK(!steps[0]);
    CHECK((steps[1]->of == 0 && !steps[1]->back));
    CHECK((steps[3]->of == 1 && !steps[3]->back));
    CHECK((steps[2]->of == 3 && steps[2]->back && steps[2]->interface == 0));
    CHECK(!steps[4]);
    // A ring: one of them stands on its own.
    const auto ring = periodic_steps({{0, 1, false, 0}, {1, 0, false, 1}}, 2);
    CHECK(!ring[0]);
    CHECK((ring[1]->of == 0 && !ring[1]->back));
}
