// SPDX-License-Identifier: Apache-2.0
// Extrusion, revolution and mirroring: what is resolved, and all that may be wrong.
#include <catch2/catch.hpp>
#include <string>

#include "topology/resolve_helpers.h"

using namespace hexweave;
using Catch::Matchers::Contains;

namespace {

/// A square over 0 <= x, y <= 1, its lower side `south`, with more lines.
std::string square(const std::string& more, const std::string& boundaries = "",
                   const std::string& low = "0") {
    return "vertices: {a: [0, " + low + "], b: [1, " + low +
           "], c: [1, 1], d: [0, 1]}\n"
           "edges:\n"
           "  south: {from: a, to: b, cells: 4}\n"
           "  west: {from: a, to: d, cells: 3}\n"
           "  north: {from: d, to: c}\n"
           "  east: {from: b, to: c}\n"
           "faces: {box: {imin: west, imax: east, jmin: south, jmax: north}}\n"
           "boundaries:\n"
           "  wall: {type: BCWall, sides: [east, north]}\n"
           "  left: {type: BCSymmetryPlane, sides: west, plane: \"x = 0\"}\n" +
           boundaries + more + "\n";
}

const std::string low = "  low: {type: BCWall, sides: south}\n";
const std::string ends = "  ends: {type: BCFarfield}\n";
const std::string named_ends = "start: ends, end: ends}";

}  // namespace

TEST_CASE("the edge on the axis of a revolution is a pole, exactly there") {
    const Topology t = resolved(
        square("revolve: {axis: [1, 0, 0], angle: 1, cells: 5, " + named_ends, ends, "1e-12"));
    CHECK(named(t.edges, "south").on_axis);
    CHECK(named(t.vertices, "a").position == Vec3{0, 0, 0});
    CHECK(t.boundaries.back().family.type == "BCDegenerateLine");
    CHECK(t.cells() == 4 * 3 * 5);
    CHECK(!t.sweep->reversed);
    CHECK(resolved(square("revolve: {axis: [-1, 0, 0], angle: 1, " + named_ends, ends))
              .sweep->reversed);
}

TEST_CASE("a sweep needs a planar grid on one side of its axis") {
    CHECK_THAT(faults(square("revolve: {axis: [1, 0, 0], center: [0, 0.5], angle: 1, " + named_ends,
                             low + ends)),
               Contains("the grid lies on both sides of the axis of 'revolve'"));
    CHECK_THAT(faults(square("revolve: {axis: [0, 0, 1], angle: 1}", low)),
               Contains("the axis of 'revolve' must lie in the plane z = 0"));
    CHECK_THAT(faults(square("extrude: {along: [1, 0, 0]}", low)),
               Contains("'along' must lead out of the plane z = 0"));
    std::string text = square("extrude: {along: [0, 0, 1], " + named_ends, low + ends);
    text.replace(text.find("d: [0, 1]"), 9, "d: [0, 1, 1]");
    CHECK_THAT(faults(text), Contains("'extrude' needs a planar grid: faces in z = 0, no blocks"));
}

TEST_CASE("no layer of a revolution turns by 180 degrees") {
    const auto turned = [](const std::string& angle, int cells) {
        return faults(square("revolve: {axis: [1, 0, 0], center: [0, -1], periodic: true, angle: " +
                                 angle + ", cells: " + std::to_string(cells) + "}",
                             low));
    };
    CHECK(
        turned("2 * pi", 2) ==
        R"(12: error: each layer of 'revolve' turns by 180 degrees: no cell can turn by 180 or more
  hint: give it at least 3 'cells'; grid lines that turn by 10 degrees from layer to layer need 36
)");
    CHECK_THAT(turned("2 * pi", 1), Contains("turns by 360 degrees"));
    CHECK_THAT(turned("-pi", 1),
               Contains("turns by 180 degrees") && Contains("give it at least 2 'cells'"));
    CHECK(turned("2 * pi", 3).empty());
    CHECK(turned("-pi", 2).empty());
    CHECK(turned("0.99 * pi", 1).empty());
}

TEST_CASE("a full turn written with too few digits is told") {
    CHECK(faults(square("revolve: {axis: [1, 0, 0], center: [0, -1], angle: 6.283185, cells: 8}",
                        low)) ==
          R"(12: error: 'revolve' turns by 3.0718e-07 radians less than a full turn
  hint: write 'angle: 2 * pi': the last plane is then the first one
)");
}

TEST_CASE("the ends of a sweep have boundaries, or are told to have none") {
    CHECK(faults(square("extrude: {along: [0, 0, 1]}", low)) ==
          "12: warning: no boundary is said for the ends of the sweep\n"
          "  hint: written as family 'unassigned', UserDefined; say 'start' and 'end', or "
          "'periodic: true'\n");
    CHECK(faults(square("extrude: {along: [0, 0, 1], periodic: true}", low)).empty());
    CHECK_THAT(faults(square("extrude: {along: [0, 0, 1], start: end, end: ends}", low + ends)),
               Contains("unknown boundary 'end'") && Contains("did you mean 'ends'?"));
    CHECK_THAT(
        faults(square("extrude: {along: [0, 0, 1], start: ends, periodic: true}", low + ends)),
        Contains("ends that are periodic are no boundary"));
    CHECK_THAT(faults(square("revolve: {axis: [1, 0, 0], angle: 2 * pi, " + named_ends, ends)),
               Contains("a full turn has no ends"));
    CHECK_THAT(faults(square("", low + ends)), Contains("boundary 'ends' lacks the key 'sides'"));
}

TEST_CASE("listed layers are those of the level medium") {
    const std::string listed =
        "extrude: {along: [0, 0, 1], cells: 2, spacing: {positions: [0, 0.3, 1]}, " + named_ends;
    CHECK(faults(square(listed, low + ends)).empty());
    CHECK_THAT(faults(square(listed + "\nlevels: {}", low + ends)),
               Contains("the sweep lists its points, which are those of the level 'medium' only") &&
                   Contains("give a formula in t"));
    CHECK_THAT(faults(square(listed + "\nmultiple_of: 3", low + ends)),
               Contains("the sweep lists the points of 2 cells, which is not a multiple of 3"));
}

TEST_CASE("the layers of an extrusion have a law that fits") {
    const std::string law = "extrude: {along: [0, 0, 1], cells: 4, spacing: ";
    CHECK(faults(square(law + "{start: 0.1}, " + named_ends, low + ends)).empty());
    CHECK_THAT(faults(square(law + "{start: 2}, " + named_ends, low + ends)),
               Contains("the spacing of 'extrude' does not fit"));
    CHECK_THAT(faults(square(law + "{like: south}, " + named_ends, low + ends)),
               Contains("the layers of 'extrude' are like no edge"));
}

TEST_CASE("periodic interfaces must outlast a sweep") {
    std::string text = square(
        "periodic: {up: {from: south, to: north, translate: [0, 1]}}\n"
        "revolve: {axis: [1, 0, 0], center: [0, -1], angle: 1, " +
            named_ends,
        ends);
    text.replace(text.find(", north]"), 8, "]");
    CHECK_THAT(faults(text), Contains("periodic interface 'up' is none in the swept grid"));
    text.replace(text.find("revolve"), text.find(", start") - text.find("revolve"),
                 "extrude: {along: [0, 0, 1]");
    CHECK(faults(text).empty());
}

TEST_CASE("a grid is mirrored at a boundary with a plane, at its border") {
    const Topology t = resolved(square("mirror: {at: left}", low));
    REQUIRE(t.mirror);
    CHECK(t.boundaries[static_cast<std::size_t>(t.mirror->boundary)].family.name == "left");
    CHECK(t.cells() == 2 * 12);
    CHECK_THAT(faults(square("mirror: {at: wall}", low)), Contains("boundary 'wall' has no plane"));
    CHECK_THAT(faults(square("mirror: {at: lef}", low)),
               Contains("unknown boundary 'lef'") && Contains("did you mean 'left'?"));
    std::string taken = square("mirror: {at: left, families: apart}", low);
    taken.replace(taken.find("  low:"), 6, "  box_mirror:");
    CHECK_THAT(faults(taken), Contains("the mirror image of 'box' would have the name "
                                       "'box_mirror', which is taken"));
    CHECK_THAT(
        faults(square("mirror: {at: left}\nrevolve: {axis: [0, 1, 0], angle: 1, " + named_ends,
                      low + ends)),
        Contains("a grid that is mirrored at a plane along the axis of 'revolve'"));
}
