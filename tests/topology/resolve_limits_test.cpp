// SPDX-License-Identifier: Apache-2.0
// The size of a grid: in space, in nodes, in memory.
#include <catch2/catch.hpp>
#include <random>

#include "geometry/lines.h"
#include "topology/limits.h"
#include "topology/resolve_helpers.h"

using namespace hexweave;

namespace {

Topology block_of(int ni, int nj, int nk) {
    Topology t;
    Block b;
    b.name = "big";
    b.extent = {ni, nj, nk};
    t.blocks.push_back(b);
    return t;
}

std::string all_of(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& d : diagnostics.all()) text += shown(d);
    return text;
}

}  // namespace

TEST_CASE("A grid's size is the greatest distance between its points") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    Topology t;
    double greatest = 0;
    for (int n = 0; n < 200; ++n) {
        const Vec3 p{coordinate(random), coordinate(random), coordinate(random)};
        for (const Vertex& v : t.vertices) greatest = std::max(greatest, distance(p, v.position));
        t.vertices.push_back({"v", p, {}});
    }
    measure_extent(t, false);
    CHECK(t.size == greatest);
    CHECK_FALSE(t.planar);
}

TEST_CASE("A grid with a point off z = 0 is not planar, also in the middle of an edge") {
    const std::string text = R"(
curves:
  arch: {polyline: [[0, 0, 0], [0.5, 0, HEIGHT], [1, 0, 0]]}
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1]}
edges:
  ab: {from: a, to: b, along: arch, cells: 4}
  ad: {from: a, to: d, cells: 5}
faces:
  f: {corners: [HAND]}
boundaries:
  all: {type: BCWall, sides: [ab, ad, b-c, c-d]}
)";
    const auto with = [&](const std::string& height, const std::string& hand) {
        std::string result = text;
        result.replace(result.find("HEIGHT"), 6, height);
        result.replace(result.find("HAND"), 4, hand);
        return result;
    };
    CHECK(resolved(with("0", "a, b, c, d")).planar);
    CHECK_FALSE(resolved(with("1", "a, b, c, d")).planar);
    CHECK(faults(with("1", "d, c, b, a")) == "");  // a surface grid has no hand
}

TEST_CASE("A zone of more nodes than 32-bit sizes count is refused, without overflow") {
    Diagnostics diagnostics;
    CHECK(check_zone_sizes(block_of(1291, 1290, 1289), diagnostics));
    CHECK_FALSE(check_zone_sizes(block_of(2000000000, 2000000000, 2000000000), diagnostics));
    CHECK(
        all_of(diagnostics) ==
        R"(file: error: block 'big' has 2000000000 x 2000000000 x 2000000000 nodes, 8e+27 in all: more than the 2147483647 that a CGNS zone can hold, and about 2.06e+18 TB of memory
  hint: give its edges fewer cells, or split it
)");
}

TEST_CASE("A grid larger than memory is refused with both figures") {
    const Topology t = block_of(601, 601, 601);
    Diagnostics diagnostics;
    check_memory(t, 4, 56'100'000'000, diagnostics);
    CHECK(all_of(diagnostics) == "");
    check_memory(t, 4, 23'000'000'000, diagnostics);
    CHECK(all_of(diagnostics) ==
          R"(file: error: this grid needs about 56 GB; this machine has 23 GB
  hint: block 'big' is the largest, with 601 x 601 x 601 nodes: give its edges fewer cells
)");
}

TEST_CASE("Memory counts the zones in flight, and all zones held") {
    Topology t = block_of(11, 11, 11);
    const double one = estimated_bytes(t, 1);
    t.blocks.push_back(t.blocks.front());
    CHECK(estimated_bytes(t, 2) == Approx(2 * one));
    CHECK(estimated_bytes(t, 1) < 2 * one);
    CHECK(estimated_bytes(t, 1) > one);
}
