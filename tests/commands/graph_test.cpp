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
