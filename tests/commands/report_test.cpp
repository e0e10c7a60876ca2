// SPDX-License-Identifier: Apache-2.0
// `hexweave report` as a user meets it: the page in a browser, and what can go wrong.
#include <catch2/catch.hpp>
#include <string>

#include "tests/commands/program.h"

using namespace hexweave::testing;
using Catch::Contains;

namespace {

/// Opens the page in a browser; false, with a warning, where there is none.
void check_in_browser(const Scratch& scratch, const std::string& arguments) {
    const Finished check = scratch.shell(
        "/usr/bin/python3 " HEXWEAVE_SOURCE_DIR "/tests/tools/report_check.py " + arguments);
    if (check.exit_code == 77) {
        WARN(check.out);
        return;
    }
    INFO(check.out << check.err);
    CHECK(check.exit_code == 0);
}

}  // namespace

TEST_CASE("the report of a volume grid opens in a browser and shows a plane by a click") {
    const Scratch scratch;
    REQUIRE(scratch
                .hexweave("run --quiet '" + shipped("pipe.yaml") +
                          "' --set across=6 --set radial=8 --set along=8 -o pipe.cgns --json "
                          "pipe.json")
                .exit_code == 0);
    const Finished report =
        scratch.hexweave("report pipe.cgns --run pipe.json --plane middle:k=2 -o pipe.html");
    INFO(report.out << report.err);
    CHECK(report.exit_code == 0);
    CHECK_THAT(report.out, Contains("wrote pipe.html") && Contains("sound"));
    CHECK_THAT(scratch.read("pipe.html"), Contains("\"name\":\"radial\",\"value\":8"));
    check_in_browser(scratch, "pipe.html --planes");
}

TEST_CASE("a report takes the JSON of the run that made its grid, and of no other") {
    const Scratch scratch;
    const std::string square =
        "hexweave: 1\n"
        "vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1]}\n"
        "edges: {south: {from: a, to: b, cells: 4}, west: {from: a, to: d, cells: 2}}\n"
        "faces: {square: {corners: [a, b, c, d]}}\n"
        "levels: {names: [coarse, medium, fine]}\n"
        "require: {max_wall_angle: 10, min_angle: 80}\n";  // there are no walls
    scratch.write("square.yaml", square);
    CHECK(scratch.hexweave("run square.yaml --level all --json all.json").exit_code == 1);
    for (const char* level : {"coarse", "medium", "fine"}) {
        const Finished report = scratch.hexweave("report square." + std::string(level) +
                                                 ".cgns --run all.json -o a.html");
        INFO(report.err);
        CHECK(report.exit_code == 0);
        CHECK_THAT(report.out, Contains("): sound; 1 gate missed in the run\n"));
    }
    const auto refused = [&](const std::string& run, const std::string& reason) {
        const Finished report =
            scratch.hexweave("report square.fine.cgns -o bad.html --run " + run);
        CHECK(report.exit_code == 2);
        CHECK(report.err == "hexweave: error: --run " + run + ": " + reason + "\n");
        CHECK_FALSE(scratch.has("bad.html"));
    };
    CHECK(scratch.hexweave("run square.yaml --set none=1 --json failed.json").exit_code == 2);
    refused("failed.json", "that run made no grid");
    CHECK(scratch.hexweave("run square.yaml --json medium.json").exit_code == 1);
    refused("medium.json",
            "that run made another grid: zone 'square' has 5 x 3 x 1 nodes there, 9 x 5 x 1 nodes "
            "in the grid");
    scratch.write("other.yaml", square.substr(0, square.find("faces")) +
                                    "faces: {other: {corners: [a, b, c, d]}}\n");
    CHECK(scratch.hexweave("run other.yaml --json other.json").exit_code == 0);
    refused("other.json", "that run made another grid: it has no zone 'square'");
}

TEST_CASE("the report of a planar grid opens in a browser") {
    const Scratch scratch;
    REQUIRE(scratch.hexweave("run --quiet '" + shipped("half_cylinder.yaml") + "' -o half.cgns")
                .exit_code == 0);
    REQUIRE(scratch.hexweave("report half.cgns -o half.html").exit_code == 0);
    check_in_browser(scratch, "half.html");
}

TEST_CASE("a report is the same for any number of threads, and leaves nothing behind on errors") {
    const Scratch scratch;
    REQUIRE(scratch.hexweave("run --quiet '" + shipped("half_cylinder.yaml") + "' -o half.cgns")
                .exit_code == 0);
    REQUIRE(scratch.hexweave("report half.cgns -j 1 -o one.html").exit_code == 0);
    REQUIRE(scratch.hexweave("report half.cgns -j 2 -o two.html").exit_code == 0);
    CHECK(scratch.read("one.html") == scratch.read("two.html"));

    const std::string before = scratch.listing();
    CHECK(scratch.hexweave("report nowhere.cgns -o bad.html").exit_code == 2);
    const Finished plane = scratch.hexweave("report half.cgns --plane upper:k=1 -o bad.html");
    CHECK(plane.exit_code == 2);
    CHECK_THAT(plane.err, Contains("the grid has no zone 'upper'"));
    const Finished run = scratch.hexweave("report half.cgns --run half.cgns -o bad.html");
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Contains("--run"));
    CHECK(scratch.listing() == before);

    // A folded grid is reported all the same, and said to be so.
    scratch.write("folded.p2d", "1\n3 2\n0 2 1 0 2 1\n0 0 0 1 1 1\n");
    CHECK(scratch.hexweave("report folded.p2d -o folded.html").exit_code == 1);
    CHECK(scratch.has("folded.html"));
}
