// SPDX-License-Identifier: Apache-2.0
// Relabelling: the order of a file's entries changes nothing but indices.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "topology/resolve_helpers.h"

using namespace hexweave;

namespace {

/// Everything that a topology says, by names, in an order of its own.
std::vector<std::string> told(const Topology& t) {
    std::vector<std::string> lines{fmt::format("{:a} {}", t.size, t.planar)};
    for (const Vertex& v : t.vertices) {
        lines.push_back(fmt::format("vertex {} {:a} {:a} {:a}", v.name, v.position.x, v.position.y,
                                    v.position.z));
    }
    for (const Edge& e : t.edges) {
        lines.push_back(fmt::format("edge {} {} {} {:a} {:a} {:a} {} {} {}", e.name,
                                    vertex_name(t, e.start), vertex_name(t, e.end), e.from, e.to,
                                    e.length, e.cells, law_text(t, e), e.made));
    }
    for (const Face& f : t.faces) {
        lines.push_back(fmt::format("face {} {} | {} | {} | {} | {} {}x{} {}", f.name,
                                    corner_text(t, f.corners), side_text(t, f.sides[0]),
                                    side_text(t, f.sides[1]), side_text(t, f.sides[2]),
                                    side_text(t, f.sides[3]), f.cells_i, f.cells_j, f.made));
    }
    for (const Block& b : t.blocks) {
        std::string line = fmt::format("block {} {} {}x{}x{}", b.name, corner_text(t, b.corners),
                                       b.extent.ni, b.extent.nj, b.extent.nk);
        for (const BlockSide& side : b.sides) {
            for (const FaceUse& use : side.faces) {
                line += fmt::format(" {} {}", t.faces[static_cast<std::size_t>(use.face)].name,
                                    to_string(use.orientation, 2));
            }
        }
        lines.push_back(line);
    }
    for (const Boundary& b : t.boundaries) {
        std::vector<std::string> sides;
        for (const int s : b.sides) {
            const auto n = static_cast<std::size_t>(s);
            sides.push_back(t.is_3d() ? t.faces[n].name : t.edges[n].name);
        }
        std::sort(sides.begin(), sides.end());
        lines.push_back(fmt::format("boundary {} {}", b.family.name, fmt::join(sides, " ")));
    }
    std::sort(lines.begin(), lines.end());
    return lines;
}

void check_invariance(const std::string& text) {
    Diagnostics diagnostics;
    const auto source =
        std::make_shared<const SourceFile>(SourceFile{"t.yaml", "hexweave: 1\n" + text});
    Case c = read_case(source, {}, diagnostics);
    const std::vector<std::string> first = told(resolve(c, diagnostics));
    std::mt19937 random(7);
    for (int shuffle = 0; shuffle < 20; ++shuffle) {
        std::shuffle(c.curves.begin(), c.curves.end(), random);
        std::shuffle(c.vertices.begin(), c.vertices.end(), random);
        std::shuffle(c.edges.begin(), c.edges.end(), random);
        std::shuffle(c.faces.begin(), c.faces.end(), random);
        std::shuffle(c.blocks.begin(), c.blocks.end(), random);
        std::shuffle(c.boundaries.begin(), c.boundaries.end(), random);
        REQUIRE(told(resolve(c, diagnostics)) == first);
    }
}

}  // namespace

TEST_CASE("The order of entries does not matter to blocks") {
    check_invariance(R"(
curves:
  bow: {polyline: [[0, 0, 0], [0.5, -0.2, 0], [1, 0, 0]]}
vertices: {a: [0, 0, 0], b: [1, 0, 0], c: [1, 1, 0], d: [0, 1, 0], e: [0, 0, 1], f: [1, 0, 1], g: [1, 1, 1], h: [0, 1, 1], j: [2, 0, 0], k: [2, 1, 0], l: [2, 0, 1], o: [2, 1, 1]}
edges:
  ab: {from: b, to: a, along: bow, cells: 4}
  bj: {from: b, to: j, cells: 3}
  cb: {from: c, to: b, cells: 5, spacing: {start: 0.1}}
  fb: {from: f, to: b, cells: 6, spacing: {start: 0.02}}
  jl: {from: j, to: l, spacing: {like: fb}}
faces:
  top: {corners: [l, f, g, o]}
blocks:
  left:  {corners: [a, b, c, d, e, f, g, h]}
  right: {corners: [j, k, c, b, l, o, g, f]}
boundaries:
  wall: {type: BCWall, sides: [top, a-b-c-d]}
  far:  {type: BCFarfield, sides: [c-d-h-g]}
)");
}

TEST_CASE("The order of entries does not matter to faces, nor to laws that are equally near") {
    check_invariance(R"(
vertices: {a0: [0, 0], a1: [1, 0], a2: [2, 0], b0: [0, 1], b1: [1, 1], b2: [2, 1]}
edges:
  left: {from: a0, to: b0, cells: 9, spacing: {start: 0.02}}
  right: {from: b2, to: a2, spacing: {end: 0.02}}
  bottom: {from: a0, to: a1, cells: 5, spacing: {law: geometric, ratio: 1.1}}
  next: {from: a1, to: a2, cells: 4}
faces:
  f1: {corners: [a0, a1, b1, b0]}
  f2: {corners: [a1, a2, b2, b1]}
boundaries:
  wall: {type: BCWall, sides: [left, right]}
)");
}
