// SPDX-License-Identifier: Apache-2.0
// The first thing that a new user does: a config to begin with, which runs.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/commands/program.h"

using namespace hexweave::testing;
using Json = nlohmann::json;

TEST_CASE("every starter config runs sound, without a warning, and can be drawn") {
    const Scratch scratch;
    for (const std::string name : {"airfoil", "channel", "pipe", "wing"}) {
        INFO(name);
        const Finished init = scratch.hexweave("init my_" + name + " --template " + name);
        INFO(init.out << init.err);
        REQUIRE(init.exit_code == 0);
        const std::string text = scratch.read("my_" + name + ".yaml");
        CHECK(text.find("hexweave run my_" + name + ".yaml") != std::string::npos);
        CHECK(text.find("NAME") == std::string::npos);
        const Finished run = scratch.hexweave("run --strict my_" + name + ".yaml --json run.json");
        INFO(run.out << run.err);
        CHECK(run.exit_code == 0);
        CHECK(run.err.find("warning") == std::string::npos);
        CHECK(run.out.find("none folded") != std::string::npos);
        const Json report = Json::parse(scratch.read("run.json"))["report"];
        for (const Json& zone : report["zones"]) {
            CHECK(zone["worst_scaled_jacobian"].get<double>() > 0.25);
        }
        CHECK(scratch.has("my_" + name + ".cgns"));
        CHECK(scratch.hexweave("graph my_" + name + ".yaml -o a.svg").exit_code == 0);
    }
}

TEST_CASE("a far field that cuts the wing of the starter config is told before anything is made") {
    const Scratch scratch;
    REQUIRE(scratch.hexweave("init my_wing --template wing").exit_code == 0);
    CHECK(scratch.hexweave("check my_wing.yaml --set root.far=8").exit_code == 0);
    const Finished check =
        scratch.hexweave("check my_wing.yaml --set root.far=0.5 --set tip.far=0.5");
    INFO(check.err);
    CHECK(check.exit_code == 2);
    CHECK(check.err.find("edges 'tip.suction' and 'tip.front_up' of face 'tip_up' cross at [") !=
          std::string::npos);
}

TEST_CASE("init never replaces what is there") {
    const Scratch scratch;
    scratch.write("mine.yaml", "precious");
    for (const char* name : {"mine", "mine.yaml"}) {
        const Finished init = scratch.hexweave(std::string("init ") + name);
        CHECK(init.exit_code == 2);
        CHECK(init.err ==
              "hexweave: error: 'mine.yaml' exists; it was left as it is: give another name, or "
              "remove it\n");
    }
    std::filesystem::create_symlink("nowhere", scratch.path() / "link.yaml");
    CHECK(scratch.hexweave("init link").exit_code == 2);
    CHECK(scratch.read("mine.yaml") == "precious");
    CHECK(scratch.hexweave("init none/case").exit_code == 2);
    CHECK(scratch.listing() == "link.yaml mine.yaml");
}

TEST_CASE("an unknown template is told with the one that was meant") {
    const Scratch scratch;
    const Finished init = scratch.hexweave("init a --template airfol");
    CHECK(init.exit_code == 2);
    CHECK(init.err ==
          "hexweave: error: --template airfol: there is no such template; did you mean "
          "'airfoil'?\n");
    CHECK(scratch.listing().empty());
}

TEST_CASE("the command that init prints can be typed as it stands") {
    const Scratch scratch;
    const Finished init = scratch.hexweave("init \"my wing's\" --template channel");
    REQUIRE(init.exit_code == 0);
    const std::string now = init.out.substr(init.out.find("now:") + 4);
    CHECK(now == "   hexweave run 'my wing'\\''s.yaml'\n");
    CHECK(scratch.hexweave("check" + now.substr(now.find(" 'my"))).exit_code == 0);
}
