// SPDX-License-Identifier: Apache-2.0
// What users see when something is wrong: the message, the exit code, and files left as they were.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/commands/program.h"

using namespace hexweave::testing;
namespace fs = std::filesystem;

namespace {

/// Whether every line of `part` stands in `text`, in the same order.
bool contains_lines(const std::string& text, const std::string& part) {
    std::istringstream lines(part);
    std::size_t at = 0;
    for (std::string line; std::getline(lines, line);) {
        at = text.find(line + "\n", at);
        if (at == std::string::npos) return false;
        at += line.size() + 1;
    }
    return true;
}

}  // namespace

// The text beside a case is that of reading it alone; resolving may find more in between.
TEST_CASE("every bad case is refused with the text that stands beside it") {
    int cases = 0;
    for (const auto& entry : fs::directory_iterator(HEXWEAVE_SOURCE_DIR "/tests/cases/bad")) {
        if (entry.path().extension() != ".yaml") continue;
        if (!HEXWEAVE_HAS_CAD && entry.path().stem() == "cad") continue;
        ++cases;
        const Scratch scratch;
        const std::string name = entry.path().filename().string();
        // Some name files beside them, or in a folder there.
        fs::copy(entry.path().parent_path(), scratch.path(), fs::copy_options::recursive);
        scratch.write("out.cgns", "what was there before");
        const Finished run = scratch.hexweave("run " + name + " -o out.cgns");
        fs::path expected = entry.path();
        expected.replace_extension(".txt");
        INFO(name);
        if (!contains(slurp(expected), "error:")) {  // warnings alone do not stop a run
            CHECK(run.exit_code == 0);
            CHECK(contains_lines(run.err, slurp(expected)));
            continue;
        }
        CHECK(run.exit_code == 2);
        INFO(run.err);
        CHECK(contains_lines(run.err, slurp(expected)));
        CHECK(run.out.empty());
        CHECK(scratch.read("out.cgns") == "what was there before");
        CHECK(scratch.hexweave("check " + name).exit_code == 2);
    }
    CHECK(cases >= 25);
}

// These are read without a fault; the whole of what `check` prints stands beside each.
TEST_CASE("every case whose parts do not fit together is refused with the text beside it") {
    int cases = 0;
    const fs::path folder = HEXWEAVE_SOURCE_DIR "/tests/cases/bad/topology";
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".yaml") continue;
        ++cases;
        const Scratch scratch;
        fs::copy(entry.path(), scratch.path());
        const std::string name = entry.path().filename().string();
        fs::path expected = entry.path();
        expected.replace_extension(".txt");
        scratch.write("out.cgns", "what was there before");
        const Finished check = scratch.hexweave("check " + name);
        INFO(name);
        CHECK(check.exit_code == 2);
        CHECK(check.err == slurp(expected));
        CHECK(check.out.empty());
        CHECK(scratch.hexweave("run " + name + " -o out.cgns").exit_code == 2);
        CHECK(scratch.read("out.cgns") == "what was there before");
    }
    CHECK(cases >= 15);
}

TEST_CASE("without Open CASCADE the entries that need it are named") {
    if (HEXWEAVE_HAS_CAD) return;
    const Scratch scratch;
    scratch.write("wing.yaml",
                  "hexweave: 1\n"
                  "surfaces:\n"
                  "  wing: {cad: wing.igs, entity: 1}\n"
                  "curves:\n"
                  "  rim: {cad: wing.igs, entity: 1, edge: 2}\n");
    const Finished run = scratch.hexweave("check wing.yaml");
    INFO(run.err);
    CHECK(run.exit_code == 2);
    CHECK(contains(run.err, "wing.yaml:3:3: error: 'wing' is of a CAD file"));
    CHECK(contains(run.err, "wing.yaml:5:3: error: 'rim' is of a CAD file"));
    CHECK(contains(run.err, "-DHEXWEAVE_CAD=ON"));
    const Finished list = scratch.hexweave("geometry wing.yaml");
    CHECK(list.exit_code == 2);
    CHECK(contains(list.err, "-DHEXWEAVE_CAD=ON"));
}

TEST_CASE("the contents of a CAD file are listed") {
    if (!HEXWEAVE_HAS_CAD) return;
    const Scratch scratch;
    const std::string wing = HEXWEAVE_SOURCE_DIR "/data/wings/taper_wing.igs";
    const Finished list = scratch.hexweave("geometry --edges " + wing);
    INFO(list.out << list.err);
    CHECK(list.exit_code == 0);
    CHECK(list.err.empty());
    CHECK(contains(list.out, "taper_wing.igs: IGES, unit of length: in, 6 surfaces, 0 curves\n"));
    CHECK(contains(list.out,
                   "entity 9: B-spline surface\n"
                   "  B-spline surface, degree 3 x 3, 13 x 4 points; u 0 to 1, v 0 to 1\n"));
    const Finished json = scratch.hexweave("geometry --json - " + wing);
    const nlohmann::json root = nlohmann::json::parse(json.out);
    CHECK(root["format"] == "IGES");
    CHECK(root["unit"] == "in");
    CHECK(root["entities"].size() == 6);
    const nlohmann::json& face = root["entities"][4]["faces"][0];
    CHECK(face["points"] == nlohmann::json{13, 4});
    CHECK(face["box"]["high"][2].get<double>() == Approx(4.0301).epsilon(1e-2));
    CHECK(scratch.hexweave("geometry --json list.json " + wing).exit_code == 0);
    CHECK(scratch.read("list.json") == json.out);
    CHECK(contains(scratch.hexweave("geometry --help").out, "surfaces: {wing: {cad: FILE"));

    scratch.write("garbage.igs", "nothing of the kind\n");
    const Finished garbage = scratch.hexweave("geometry garbage.igs");
    CHECK(garbage.exit_code == 2);
    CHECK(garbage.out.empty());
    CHECK(garbage.err ==
          "hexweave: error: cannot read 'garbage.igs': it is neither an IGES nor a STEP file\n");
    CHECK(scratch.hexweave("geometry nowhere.igs").exit_code == 2);
}

TEST_CASE("the ten lines that grid a surface of a CAD file do") {
    if (!HEXWEAVE_HAS_CAD) return;
    const auto block = [](const std::string& path) {
        const std::string text = slurp(std::string(HEXWEAVE_SOURCE_DIR "/") + path);
        const std::size_t begin = text.find("hexweave: 1\nsurfaces: {top: {cad:");
        REQUIRE(begin != std::string::npos);
        return text.substr(begin, text.find("```", begin) - begin);
    };
    CHECK(block("README.md") == block("docs/format.md"));
    const Scratch scratch;
    fs::copy(HEXWEAVE_SOURCE_DIR "/data/wings/taper_wing.igs", scratch.path());
    scratch.write("top.yaml", block("README.md"));
    const Finished run = scratch.hexweave("run top.yaml");
    INFO(run.out << run.err);
    CHECK(run.exit_code == 0);
    CHECK(contains(run.out, "sound: 1 zone, 1,200 cells, none folded"));
}

TEST_CASE("a config from standard input needs a name for its grid") {
    const Scratch scratch;
    scratch.write("tiny.yaml", tiny);
    const Finished nameless = scratch.hexweave("run - <tiny.yaml");
    CHECK(nameless.exit_code == 2);
    CHECK(contains(nameless.err, "needs -o FILE"));
    const Finished named = scratch.hexweave("run - -o grid.cgns <tiny.yaml");
    INFO(named.err);
    CHECK(named.exit_code == 0);
    CHECK(scratch.listing() == "grid.cgns tiny.yaml");
}

TEST_CASE("the output is named after the config where nothing else names it") {
    const Scratch scratch;
    scratch.write("tiny.yaml", tiny);
    CHECK(scratch.hexweave("run tiny.yaml").exit_code == 0);
    CHECK(scratch.has("tiny.cgns"));
}

TEST_CASE("the command line is checked") {
    const Scratch scratch;
    scratch.write("tiny.yaml", tiny);
    CHECK(scratch.hexweave("").exit_code == 2);
    CHECK(scratch.hexweave("fly").exit_code == 2);
    CHECK(scratch.hexweave("run").exit_code == 2);
    CHECK(scratch.hexweave("run missing.yaml").exit_code == 2);
    CHECK(contains(scratch.hexweave("run missing.yaml").err,
                   "cannot read 'missing.yaml': No such file or directory"));
    CHECK(scratch.hexweave("run tiny.yaml --set cells").exit_code == 2);
    CHECK(scratch.hexweave("run tiny.yaml -o tiny.txt").exit_code == 2);
    CHECK(scratch.hexweave("run tiny.yaml -j 0").exit_code == 2);
    CHECK(scratch.hexweave("run tiny.yaml --level fin").exit_code == 2);
    CHECK(contains(scratch.hexweave("run tiny.yaml --level fin").err,
                   "the levels are coarse, medium, fine, or all; did you mean 'fine'?"));
    CHECK(scratch.listing() == "tiny.yaml");
    CHECK(scratch.hexweave("--help").exit_code == 0);
    CHECK(contains(scratch.hexweave("--help").out, "Exit codes"));
    CHECK(contains(scratch.hexweave("compare --help").out, "1 different"));
    CHECK(contains(scratch.hexweave("run --help").out, "passes its gates"));
    CHECK_FALSE(contains(scratch.hexweave("plot --help").out, "1 the grid"));
    CHECK(contains(scratch.hexweave("--version").out, "hexweave 0."));
}

TEST_CASE("a command or an option that is misspelled is told with the one that was meant") {
    const Scratch scratch;
    scratch.write("tiny.yaml", tiny);
    const auto told = [&](const std::string& arguments, const std::string& message) {
        const Finished run = scratch.hexweave(arguments);
        INFO(arguments);
        CHECK(run.exit_code == 2);
        CHECK(run.err == "hexweave: error: " + message + "\n");
    };
    told("rnu tiny.yaml", "hexweave has no command 'rnu'; did you mean 'run'?");
    told("chekc", "hexweave has no command 'chekc'; did you mean 'check'?");
    told("run tiny.yaml --thraeds 2",
         "hexweave run has no option '--thraeds'; did you mean '--threads'?");
    told("check tiny.yaml --expalin=a",
         "hexweave check has no option '--expalin'; did you mean '--explain'?");
    told("run tiny.yaml --out a.cgns",
         "hexweave run has no option '--out'; did you mean '--output'?");
    told("run tiny.yaml -j1 -j1", "--threads is given twice; see 'hexweave run --help'");
    told("--verison", "hexweave has no option '--verison'; did you mean '--version'?");
    told("tiny.yaml", "the command is missing: did you mean 'hexweave run tiny.yaml'?");
    told("", "a command is missing, such as run, check or quality; see 'hexweave --help'");
    told("run", "CONFIG is required; see 'hexweave run --help'");
    told("run tiny.yaml -j 0",
         "--threads: Value 0 not in range 1 to 65536; see 'hexweave run --help'");
    told("plot tiny.cgns -o a.png wake 3",
         "cannot tell what 'wake 3' is for; see 'hexweave plot --help'");
    told(
        "run tiny.yaml --set wall=1 nj=100",
        "what is 'nj=100' for? A parameter is set by '--set nj=100', each with a --set of its own");
    told("quality tiny.yaml",
         "'tiny.yaml' is a config, not a grid; 'hexweave run tiny.yaml' makes its grid");
    told("plot tiny.yaml -o a.png --view fornt",
         "--view fornt: a view is top, front, side, iso or X,Y,Z; did you mean 'front'?");
    CHECK(scratch.hexweave("fly").exit_code == 2);  // nothing is near: the command line's own words
    CHECK(
        contains(scratch.hexweave("run tiny.yaml --set cout=3").err, "the file has no parameters"));
    CHECK(scratch.listing() == "tiny.yaml");
}

TEST_CASE("check explains the names that it is asked about") {
    const Scratch scratch;
    const Finished told =
        scratch.hexweave("check " + shipped("naca0012.yaml") + " --explain upper_ray --explain te");
    INFO(told.out + told.err);
    CHECK(told.exit_code == 0);
    CHECK(contains(told.out, "64 cells: as edge 'nose_ray'"));
    CHECK(contains(told.out, "vertex 'te'\n"));
    CHECK(scratch.listing().empty());
    const Finished unknown =
        scratch.hexweave("check " + shipped("naca0012.yaml") + " --explain uper_ray");
    CHECK(unknown.exit_code == 2);
    CHECK(unknown.err ==
          "hexweave: error: --explain uper_ray: the grid has no such vertex, edge, face, block, "
          "boundary or instance; did you mean 'upper_ray'?\n");
}

TEST_CASE("plot says what it cannot draw") {
    const Scratch scratch;
    scratch.write("tiny.yaml", tiny);
    scratch.write("text.cgns", "this is no grid");
    REQUIRE(scratch.hexweave("run --quiet tiny.yaml").exit_code == 0);
    const auto refused = [&scratch](const std::string& arguments, const std::string& message) {
        const Finished plot = scratch.hexweave("plot " + arguments);
        INFO(arguments << ": " << plot.err);
        CHECK(plot.exit_code == 2);
        CHECK(contains(plot.err, message));
    };
    refused("missing.cgns -o a.png", "missing.cgns");
    refused("text.cgns -o a.png", "text.cgns");
    refused("tiny.cgns -o a.gif", ".svg");
    refused("tiny.cgns -o a.png --family rin", "'rim'");
    refused("tiny.cgns -o a.png --plane '*:k=1'", "grid of volumes");
    refused("tiny.cgns", "--output");
    CHECK(scratch.hexweave("plot tiny.cgns -o none/a.png").exit_code == 2);
    CHECK(scratch.listing() == "text.cgns tiny.cgns tiny.yaml");
    CHECK(scratch.hexweave("plot tiny.cgns -o a.svg --color family").exit_code == 0);
    CHECK(contains(scratch.read("a.svg"), "<svg"));
}

TEST_CASE("a grid larger than the memory is told before anything is made") {
    const Scratch scratch;
    scratch.write("tiny.yaml", tiny);
    std::string text = tiny;
    text.replace(text.find("cells: 4"), 8, "cells: 40000");
    text.replace(text.find("cells: 3"), 8, "cells: 50000");
    scratch.write("huge.yaml", text);
    const Finished run = scratch.hexweave("run huge.yaml");
    INFO(run.err);
    CHECK(run.exit_code == 2);
    CHECK(contains(run.err, "GB"));
    CHECK(!scratch.has("huge.cgns"));
}

TEST_CASE("with --strict a warning is an error") {
    const Scratch scratch;
    scratch.write("open.yaml", tiny.substr(0, tiny.find("boundaries")));
    const Finished lax = scratch.hexweave("run open.yaml");
    CHECK(lax.exit_code == 0);
    CHECK(contains(lax.err, "warning"));
    fs::remove(scratch.path() / "open.cgns");
    const Finished strict = scratch.hexweave("run --strict open.yaml");
    CHECK(strict.exit_code == 2);
    CHECK(!scratch.has("open.cgns"));
}

TEST_CASE("the JSON tells the outcome whatever it was") {
    const Scratch scratch;
    scratch.write("tiny.yaml", tiny);
    scratch.write("bad.yaml", "hexweave: 1\nvertices: {a: [0, 0, q]}\n");
    CHECK(scratch.hexweave("run bad.yaml --json bad.json").exit_code == 2);
    const auto bad = nlohmann::json::parse(scratch.read("bad.json"));
    CHECK(bad["exit_code"] == 2);
    CHECK(bad["report"].is_null());
    CHECK(bad["diagnostics"][0]["line"] == 2);
    CHECK(bad["diagnostics"][0]["file"] == "bad.yaml");
    const Finished printed = scratch.hexweave("run tiny.yaml --json -");
    const auto good = nlohmann::json::parse(printed.out);
    CHECK(good["hexweave_json"] == 1);
    CHECK(good["outputs"][0] == "tiny.cgns");
    CHECK(good["report"]["cells"] == 12);
}

TEST_CASE("a result that did not converge is written, named and gives exit code 1") {
    const Scratch scratch;
    scratch.write("hard.yaml", shipped_with("obstacle.yaml", "solver: {", "maximum_cycles: 2, "));
    const Finished run = scratch.hexweave("run hard.yaml -o hard.cgns");
    CHECK(run.exit_code == 1);
    CHECK(scratch.has("hard.cgns"));
    CHECK(contains(run.out, "NOT SOUND"));
    CHECK(contains(run.out, "face 'ring' not converged after 2 cycles"));
}

TEST_CASE("a folded result is written, named and gives exit code 1") {
    const Scratch scratch;
    std::string text = slurp(shipped("obstacle.yaml"));
    const std::string orthogonal = "orthogonal: [jmin]";
    const std::size_t at = text.find(orthogonal);
    REQUIRE(at != std::string::npos);
    text.replace(at, orthogonal.size(), "method: algebraic");
    scratch.write("folded.yaml", text);
    const Finished run = scratch.hexweave("run folded.yaml -o folded.cgns");
    CHECK(run.exit_code == 1);
    CHECK(scratch.has("folded.cgns"));
    CHECK(contains(run.out, "folded cells in zone 'ring'"));
}

namespace {

/// A square whose south side is drawn into it, up to a tip.
std::string with_tip(const std::string& tip) {
    return "hexweave: 1\ncurves:\n  tip: {polyline: [[0, 0], " + tip + R"(, [1, 0.3]]}
vertices: {a: [0, 0], b: [1, 0.3], c: [1, 1], d: [0, 1]}
edges:
  south: {from: a, to: b, along: tip, cells: 9}
  west: {from: a, to: d, cells: 4}
faces:
  square: {corners: [a, b, c, d]}
boundaries:
  rim: {type: BCWall, sides: [south, west, b-c, c-d]}
)";
}

}  // namespace

TEST_CASE("where untangling acted, and where it failed, is told") {
    const Scratch scratch;
    scratch.write("hidden.yaml", with_tip("[0.8, 0.1], [0.2, 0.2]"));
    const Finished cured = scratch.hexweave("run hidden.yaml --verbose --json hidden.json");
    INFO(cured.out << cured.err);
    CHECK(cured.exit_code == 0);
    CHECK(contains(cured.out, "untangled: "));
    CHECK(contains(cured.out, "cycle   1  displacement "));
    CHECK_FALSE(contains(cured.out, "STILL FOLDED"));
    const auto solve_of = [&](const char* file) {
        return nlohmann::json::parse(scratch.read(file))["report"]["solves"][0];
    };
    const auto solve = solve_of("hidden.json");
    CHECK(solve["status"] == "converged");
    CHECK(solve["cycles"] == solve["history"].size());
    CHECK(solve["rate"].is_number());
    CHECK(solve["safeguards"].empty());
    CHECK(solve["folded_after"] == 0);
    CHECK(solve["untangling"]["folded_before"] > 0);
    CHECK(solve["untangling"]["points_moved"] > 0);
    CHECK(solve["untangling"]["place"].size() == 3);
    CHECK(solve["untangling"]["left_at"].is_null());

    scratch.write("crossed.yaml", folded_by_its_boundary);
    const Finished failed = scratch.hexweave("run crossed.yaml --json crossed.json");
    INFO(failed.out);
    CHECK(failed.exit_code == 1);
    CHECK(contains(failed.out, "STILL FOLDED at ("));
    CHECK(contains(failed.out, "face 'tie' could not be untangled at ("));
    const auto left = solve_of("crossed.json");
    CHECK(left["folded_after"] > 0);
    CHECK(left["untangling"]["left_at"].size() == 3);
    const auto report = nlohmann::json::parse(scratch.read("crossed.json"))["report"];
    CHECK(left["folded_after"] == report["zones"][0]["folded"]);
}

TEST_CASE("an output that cannot be written is told before the work, and nothing is left") {
    const Scratch scratch;
    scratch.write("tiny.yaml", tiny);
    scratch.write("file", "");
    const Finished missing = scratch.hexweave("run tiny.yaml -o nowhere/grid.cgns");
    CHECK(missing.exit_code == 2);
    CHECK(contains(missing.err, "nowhere"));
    const Finished through = scratch.hexweave("run tiny.yaml -o file/grid.cgns");
    CHECK(through.exit_code == 2);
    CHECK(scratch.listing() == "file tiny.yaml");
}

TEST_CASE("a full disk gives exit code 3 and leaves the former grid as it was") {
    const Scratch scratch;
    scratch.write("tiny.yaml", tiny);
    scratch.write("full.sh",
                  "mount -t tmpfs -o size=48k none disk || exit 77\n"
                  "printf former >disk/grid.cgns\n"
                  "'" HEXWEAVE_PROGRAM
                  "' run tiny.yaml -o disk/grid.cgns\n"
                  "echo \"exit $? with $(ls -A disk): $(cat disk/grid.cgns)\"\n");
    const Finished run = scratch.shell("mkdir disk && unshare -Urm sh full.sh");
    INFO(run.out << run.err);
    if (run.exit_code != 0) {
        WARN("skipped: no user namespace with a small filesystem can be had here: " << run.err);
        return;
    }
    CHECK(contains(run.out, "exit 3 with grid.cgns: former"));
    CHECK(contains(run.err, "cannot write 'disk/grid.cgns': no space left on device"));
}

TEST_CASE("a file-size limit gives exit code 3 and leaves the former grid as it was") {
    const Scratch scratch;
    scratch.write("tiny.yaml", tiny);
    scratch.write("grid.cgns", "former");
    // SIGXFSZ is ignored so that writing fails as on a full disk.
    const Finished run = scratch.shell("trap '' XFSZ; ulimit -f 8; '" HEXWEAVE_PROGRAM
                                       "' run tiny.yaml -o grid.cgns");
    INFO(run.err);
    CHECK(run.exit_code == 3);
    CHECK(contains(run.err, "cannot write 'grid.cgns'"));
    CHECK(scratch.read("grid.cgns") == "former");
    CHECK(scratch.listing() == "grid.cgns tiny.yaml");
}

TEST_CASE("an interrupted run leaves nothing behind") {
    const Scratch scratch;
    const std::string config = shipped("pipe.yaml");
    scratch.write("grid.cgns", "former");
    const Finished run = scratch.shell(
        std::string("timeout --preserve-status -s INT 0.4 '") + HEXWEAVE_PROGRAM + "' run " +
        config + " --set across=60 --set radial=60 --set along=60 -o grid.cgns");
    CHECK(run.exit_code == 130);
    CHECK(scratch.read("grid.cgns") == "former");
    CHECK(scratch.listing() == "grid.cgns");
}
