// SPDX-License-Identifier: Apache-2.0
// The drawing of a topology: what stands in it, as text in its SVG.
#include <catch2/catch.hpp>
#include <regex>
#include <string>

#include "tests/commands/program.h"

using namespace hexweave::testing;

namespace {

bool says(const std::string& svg, const std::string& text) {
    return svg.find(">" + text + "</text>") != std::string::npos;
}

/// Where the text stands: its x and y.
std::pair<double, double> place_of(const std::string& svg, const std::string& text) {
    std::smatch match;
    const std::regex label("<text x=\"([-0-9.]+)\" y=\"([-0-9.]+)\"[^>]*>" + text + "</text>");
    REQUIRE(std::regex_search(svg, match, label));
    return {std::stod(match[1]), std::stod(match[2])};
}

}  // namespace

TEST_CASE("the graph of a planar case names what is in it") {
    const Scratch scratch;
    const Finished graph =
        scratch.hexweave("graph " + shipped("naca0012.yaml") + " -o naca0012.svg");
    INFO(graph.out << graph.err);
    REQUIRE(graph.exit_code == 0);
    CHECK(scratch.listing() == "naca0012.svg");
    const std::string svg = scratch.read("naca0012.svg");
    for (const char* text : {"le", "te", "far_up", "front_up", "rear_low", "32 x 64 cells",
                             "suction_front · 32", "nose_ray · 64", "airfoil (BCWallInviscid)",
                             "farfield (BCFarfield)", "i", "j", "NACA 0012, O-type Euler grid"}) {
        INFO(text);
        CHECK(says(svg, text));
    }
}

TEST_CASE("a far field of twenty chords leaves the airfoil legible in the graph") {
    const Scratch scratch;
    REQUIRE(scratch.hexweave("graph " + shipped("naca0012.yaml") + " -o a.svg").exit_code == 0);
    const std::string svg = scratch.read("a.svg");
    const double chord = place_of(svg, "te").first - place_of(svg, "le").first;
    const double field = place_of(svg, "far_te").first - place_of(svg, "far_le").first;
    CHECK(chord > 0.2 * field);
    CHECK(chord < 0.5 * field);
    CHECK(svg.find("not to scale") != std::string::npos);
    // Nothing is far from anything in a square: it is drawn as it is.
    REQUIRE(scratch.hexweave("graph " + shipped("unit_square.yaml") + " -o b.svg").exit_code == 0);
    CHECK(scratch.read("b.svg").find("not to scale") == std::string::npos);
}

TEST_CASE("the graph of blocks tells which faces they share") {
    const Scratch scratch;
    REQUIRE(scratch.hexweave("graph " + shipped("pipe.yaml") + " -o pipe.svg").exit_code == 0);
    const std::string svg = scratch.read("pipe.svg");
    for (const char* text : {"middle", "east", "a0-a1-b1-b0", "24 x 16 x 40 cells", "kmin",
                             "wall (BCWallViscous)", "inlet_arc_0 · 16", "p0"}) {
        INFO(text);
        CHECK(says(svg, text));
    }
    CHECK(!says(svg, "wall_0"));  // no block shares it
}

TEST_CASE("the graph draws periodic pairs, in the plane and between blocks") {
    const Scratch scratch;
    REQUIRE(scratch.hexweave("graph " + shipped("vane.yaml") + " -o a.svg").exit_code == 0);
    const std::string plane = scratch.read("a.svg");
    CHECK(says(plane, "passage (periodic: translation [0, 0.85])"));
    const auto often = [](const std::string& text, const std::string& word) {
        int count = 0;
        for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at) ++count;
        return count;
    };
    CHECK(often(plane, ">passage</text>") == 3);  // an arrow for each pair
    CHECK(!says(plane, "cut: a face is joined to itself"));

    REQUIRE(scratch.hexweave("graph " + shipped("vane_annulus.yaml") + " -o b.svg").exit_code == 0);
    const std::string blocks = scratch.read("b.svg");
    for (const char* pair :
         {"bottom_in = top_in", "bottom_mid = top_mid", "bottom_out = top_out"}) {
        CHECK(says(blocks, pair));
    }
    CHECK(blocks.find("(periodic: rotation about x by -0.174533 through") != std::string::npos);
}

TEST_CASE("the graph draws what is joined to itself, and tells of sweeps and mirrors") {
    const Scratch scratch;
    scratch.write("ring.yaml", R"(hexweave: 1
curves: {inner: {circle: {center: [0, 0], radius: 1}}, outer: {circle: {center: [0, 0], radius: 3}}}
vertices: {a: [1, 0], b: [3, 0]}
edges:
  wall: {from: a, to: a, along: inner, cells: 40}
  far: {from: b, to: b, along: outer}
  seam: {from: a, to: b, cells: 12}
faces: {ring: {imin: seam, imax: seam, jmin: -wall, jmax: -far}}
boundaries: {walls: {type: BCWall, sides: [wall, far]}}
extrude: {along: [0, 0, 1], cells: 4, periodic: true}
)");
    REQUIRE(scratch.hexweave("graph ring.yaml -o ring.svg").exit_code == 0);
    const std::string ring = scratch.read("ring.svg");
    CHECK(says(ring, "cut: a face is joined to itself"));
    CHECK(says(ring, "swept by a translation [0, 0, 1], 4 cells, its ends joined"));

    scratch.write("box.yaml", R"(hexweave: 1
vertices: {a: [0, 0, 0], b: [2, 0, 0], c: [2, 1, 0], d: [0, 1, 0],
           e: [0, 0, 1], f: [2, 0, 1], g: [2, 1, 1], h: [0, 1, 1]}
edges: {ab: {from: a, to: b, cells: 6}, ad: {from: a, to: d, cells: 4}, ae: {from: a, to: e, cells: 3}}
blocks: {box: {corners: [a, b, c, d, e, f, g, h]}}
boundaries: {walls: {type: BCWall, sides: [a-b-c-d, e-f-g-h, a-b-f-e, d-c-g-h]}}
periodic: {along: {from: a-d-h-e, to: b-c-g-f, translate: [2, 0, 0]}}
)");
    REQUIRE(scratch.hexweave("graph box.yaml -o box.svg").exit_code == 0);
    CHECK(says(scratch.read("box.svg"), "a-d-h-e = b-c-g-f"));
}

TEST_CASE("a graph is the same every time, a PNG where the name says so, and never half") {
    const Scratch scratch;
    const std::string config = shipped("half_cylinder.yaml");
    CHECK(scratch.hexweave("graph " + config + " -o a.svg").exit_code == 0);
    CHECK(scratch.hexweave("graph " + config + " -o b.svg -j 2").exit_code == 0);
    CHECK((scratch.read("a.svg") == scratch.read("b.svg")));
    CHECK(scratch.hexweave("graph " + config + " -o c.png").exit_code == 0);
    CHECK(scratch.read("c.png").starts_with("\x89PNG"));
    CHECK(scratch.hexweave("graph " + config + " -o d.gif").exit_code == 2);
    CHECK(scratch.hexweave("graph " + config).exit_code == 2);
    scratch.write("bad.yaml", "hexweave: 1\nvertices: {a: [0, 0, q]}\n");
    CHECK(scratch.hexweave("graph bad.yaml -o a.svg").exit_code == 2);
    CHECK((scratch.read("a.svg") == scratch.read("b.svg")));
    CHECK(scratch.listing() == "a.svg b.svg bad.yaml c.png");
}
