// SPDX-License-Identifier: Apache-2.0
// The solver on shipped cases: exact surfaces, and grids that do not depend on how they began.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

#include "core/multiblock.h"
#include "io/cgns.h"
#include "tests/commands/images.h"
#include "tests/commands/program.h"

using namespace hexweave;
using namespace hexweave::testing;
using Json = nlohmann::json;

namespace {

/// The greatest distance of the grid's nodes from Scherk's surface z = f(x, y), to first order: the
/// distance in z over the length of the normal (-f_x, -f_y, 1).
double distance_to_scherk(const Scratch& scratch, int cells, int stretched) {
    const Finished run =
        scratch.hexweave("run --quiet " + shipped("scherk.yaml") +
                         " --set tolerance=1e-6 --set cells=" + std::to_string(cells) +
                         " --set stretched=" + std::to_string(stretched) + " -o s.cgns");
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    const PointField points = read_cgns(scratch.path() / "s.cgns").zones.at(0).points;
    double worst = 0;
    for (std::size_t n = 0; n < points.extent().nodes(); ++n) {
        const Vec3 p = points[n];
        const Vec3 normal{-std::tan(p.x), std::tan(p.y), 1};
        const double in_z = p.z - std::log(std::cos(p.y) / std::cos(p.x));
        worst = std::max(worst, std::abs(in_z) / norm(normal));
    }
    return worst;
}

/// The greatest displacement between two grids, relative to the shortest edge at each node.
double greatest_difference(const PointField& a, const PointField& b) {
    const Extent e = a.extent();
    const std::array<Node, 6> steps{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
    double worst = 0;
    for (int k = 0; k < e.nk; ++k)
        for (int j = 0; j < e.nj; ++j)
            for (int i = 0; i < e.ni; ++i) {
                double shortest = 1e300;
                for (const Node& s : steps) {
                    const Node n{i + s[0], j + s[1], k + s[2]};
                    if (n[0] < 0 || n[0] >= e.ni || n[1] < 0 || n[1] >= e.nj || n[2] < 0 ||
                        n[2] >= e.nk) {
                        continue;
                    }
                    shortest = std::min(shortest, distance(a(i, j, k), a(n[0], n[1], n[2])));
                }
                worst = std::max(worst, distance(a(i, j, k), b(i, j, k)) / shortest);
            }
    return worst;
}

}  // namespace

TEST_CASE("the transfinite wall of the conical pipe lies on the cone") {
    const Scratch scratch;
    REQUIRE(scratch
                .hexweave("run --quiet " + shipped("pipe.yaml") +
                          " --set across=8 --set radial=8 --set along=10 -o pipe.cgns")
                .exit_code == 0);
    std::size_t nodes = 0;
    double worst = 0;
    for_each_node(read_cgns(scratch.path() / "pipe.cgns"), "wall", [&](const Vec3& p) {
        ++nodes;
        worst = std::max(worst, std::abs(std::hypot(p.x, p.y) - (0.5 - 0.1 * p.z)));
    });
    CHECK(nodes == std::size_t{4} * 9 * 11);
    CHECK(worst < 1e-14);
}

TEST_CASE("the transfinite start grid of the obstacle is severely folded") {
    const Scratch scratch;
    REQUIRE(
        scratch.hexweave("run --json - " + shipped("obstacle.yaml") + " >report.json").exit_code ==
        0);
    const Json report = Json::parse(scratch.read("report.json"));
    CHECK(report["report"]["solves"][0]["folded_before"] > 500);
    CHECK(report["report"]["solves"][0]["folded_after"] == 0);
    CHECK(report["report"]["folded"] == 0);
}

TEST_CASE(
    "the Scherk grid nears the exact surface with second order, however its edges are spaced") {
    const Scratch scratch;
    for (const int stretched : {0, 1}) {
        const double coarse = distance_to_scherk(scratch, 40, stretched);
        const double medium = distance_to_scherk(scratch, 80, stretched);
        const double fine = distance_to_scherk(scratch, 160, stretched);
        INFO("distances " << coarse << ", " << medium << ", " << fine);
        CHECK(std::log2(coarse / medium) > 1.8);
        CHECK(std::log2(medium / fine) > 1.88);
        CHECK(fine < 5e-4);
    }
}

TEST_CASE("the grid does not depend on the start grid, folded or not") {
    const std::string coarse_pipe = " --set across=8 --set radial=12 --set along=10";
    for (const auto& [name, sizes] :
         {std::pair<std::string, std::string>{"naca0012", ""}, {"pipe", coarse_pipe}}) {
        const Scratch scratch;
        const auto arguments = [&sizes = sizes](const std::string& config, const char* grid) {
            return fmt::format("run '{}' --set tolerance=1e-8{} --json report.json -o {}", config,
                               sizes, grid);
        };
        scratch.write("folded.yaml", shipped_with(name + ".yaml", "solver: {", "start: folded, "));
        REQUIRE(scratch.hexweave(arguments(shipped(name + ".yaml"), "plain.cgns")).exit_code == 0);
        const Finished folded = scratch.hexweave(arguments("folded.yaml", "folded.cgns"));
        INFO(name << folded.err << folded.out);
        REQUIRE(folded.exit_code == 0);
        const Json solves = Json::parse(scratch.read("report.json"))["report"]["solves"];
        CHECK(solves.back()["folded_before"] > 100);
        const MultiblockGrid a = read_cgns(scratch.path() / "plain.cgns");
        const MultiblockGrid b = read_cgns(scratch.path() / "folded.cgns");
        for (std::size_t z = 0; z < a.zones.size(); ++z) {
            CHECK(greatest_difference(a.zones[z].points, b.zones[z].points) < 1e-6);
        }
    }
}
