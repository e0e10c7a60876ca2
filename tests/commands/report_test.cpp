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
