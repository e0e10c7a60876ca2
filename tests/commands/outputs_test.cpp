// SPDX-License-Identifier: Apache-2.0
// No output is aimed at an input or at another output, and a path that cannot be written is told
// before the work.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/commands/program.h"

using namespace hexweave::testing;
namespace fs = std::filesystem;

namespace {

/// A folder with a case, its grid, and other names for both.
class Workshop : public Scratch {
public:
    Workshop() {
        write("tiny.yaml", tiny);
        REQUIRE(hexweave("run tiny.yaml --quiet -o grid.cgns --json run.json").exit_code == 0);
        REQUIRE(hexweave("convert grid.cgns grid.xyz").exit_code == 0);
        fs::create_symlink("tiny.yaml", path() / "link.yaml");
        fs::create_symlink("grid.cgns", path() / "link.cgns");
        fs::create_hard_link(path() / "grid.cgns", path() / "hard.cgns");
        fs::create_directory(path() / "folder");
    }

    /// Runs a command that must be refused with this message, every file left as it was.
    void refuses(const std::string& arguments, const std::string& message) const {
        const std::string names = listing();
        const std::vector<std::string> kept{"tiny.yaml", "grid.cgns", "grid.xyz", "grid.nmf",
                                            "run.json"};
        std::vector<std::string> before;
        for (const std::string& name : kept) before.push_back(read(name));
        const Finished run = hexweave(arguments);
        INFO(arguments << ": " << run.out << run.err);
        CHECK(run.exit_code == 2);
        CHECK(contains(run.err, message));
        CHECK(run.out.empty());
        CHECK(listing() == names);
        for (std::size_t n = 0; n < kept.size(); ++n) CHECK(read(kept[n]) == before[n]);
    }
};

}  // namespace

TEST_CASE("no command overwrites what it reads") {
    const Workshop shop;
    const std::string config = "--json 'tiny.yaml' would overwrite the config 'tiny.yaml'";
    shop.refuses("run tiny.yaml --json tiny.yaml -o y.cgns", config);
    shop.refuses("check tiny.yaml --json tiny.yaml", config);
    shop.refuses("graph tiny.yaml -o y.svg --json tiny.yaml", config);
    shop.refuses("check tiny.yaml --json folder/../link.yaml",
                 "--json 'folder/../link.yaml' would overwrite the config 'tiny.yaml'");
    shop.refuses("run link.yaml --golden . --json ./tiny.yaml",
                 "--json './tiny.yaml' would overwrite the config 'link.yaml'");
    const std::string grid = "would overwrite the grid 'grid.cgns'";
    shop.refuses("quality grid.cgns --json grid.cgns", "--json 'grid.cgns' " + grid);
    shop.refuses("quality grid.cgns --json hard.cgns", "--json 'hard.cgns' " + grid);
    shop.refuses("quality grid.xyz --json grid.nmf",
                 "--json 'grid.nmf' would overwrite the map of the grid 'grid.nmf'");
    shop.refuses("compare grid.cgns hard.cgns --json link.cgns", "--json 'link.cgns' " + grid);
    shop.refuses("compare grid.xyz grid.cgns --json grid.cgns",
                 "--json 'grid.cgns' would overwrite the golden grid 'grid.cgns'");
    shop.refuses("report grid.cgns -o link.cgns", "-o 'link.cgns' " + grid);
    shop.refuses("report grid.cgns --run run.json -o run.json",
                 "-o 'run.json' would overwrite --run 'run.json'");
    shop.refuses("convert grid.cgns link.cgns", "OUT 'link.cgns' " + grid);
    shop.refuses("convert grid.xyz grid.p3d",
                 "the map of OUT 'grid.nmf' would overwrite the map of the grid 'grid.nmf'");
    shop.refuses("geometry grid.xyz --json grid.xyz",
                 "--json 'grid.xyz' would overwrite the file 'grid.xyz'");
    fs::copy_file(shop.path() / "grid.cgns", shop.path() / "grid.png");
    shop.refuses("plot grid.png -o grid.png", "-o 'grid.png' would overwrite the grid");
}

TEST_CASE("no command writes two outputs to one file") {
    const Workshop shop;
    shop.refuses("run tiny.yaml -o grid.cgns --json link.cgns",
                 "two outputs would be written to 'link.cgns': -o 'grid.cgns' and --json");
    shop.refuses("run tiny.yaml -o new.cgns --json folder/../new.cgns",
                 "-o 'new.cgns' and --json 'folder/../new.cgns'");
    shop.refuses("run tiny.yaml -o a.xyz -o a.p3d",
                 "the map of -o 'a.nmf' and the map of -o 'a.nmf'");
    shop.refuses("run tiny.yaml -o a.vtm --json a", "'a': the folder of -o 'a' and --json 'a'");
    shop.refuses("run tiny.yaml -o folder.vtm --json folder/zone1.vts",
                 "--json 'folder/zone1.vts'");
    shop.refuses("graph tiny.yaml -o b.svg --json b.svg", "-o 'b.svg' and --json 'b.svg'");
    fs::copy_file(shop.path() / "tiny.yaml", shop.path() / "folder" / "tiny.yaml");
    shop.refuses("run tiny.yaml folder/tiny.yaml --golden folder",
                 "two outputs would be written to 'folder/tiny.cgns'");
    // What may stand together does.
    const Finished together = shop.hexweave("run tiny.yaml -o folder.vtm --json folder/run.json");
    INFO(together.err);
    CHECK(together.exit_code == 0);
}

TEST_CASE("no grid overwrites what its config names, and the message has the place") {
    const Workshop shop;
    shop.write("part.yaml", "hexweave: 1\nparameters: {twice: 2}\n");
    shop.write("named.yaml", tiny +
                                 "include: part.yaml\n"
                                 "surfaces: {s: {control_points: {file: points.xyz}}}\n"
                                 "output: {plot3d: ./points.xyz}\n");
    shop.write("points.xyz", "1\n2 2 1\n0 1 0 1\n0 0 1 1\n0 0 0 0\n");
    const std::string points = shop.read("points.xyz");
    const std::string named = "'points.xyz', which named.yaml:11 names";
    for (const char* command : {"run", "check"}) {
        const Finished run =
            shop.hexweave(std::string(command) + " named.yaml --json outcome.json");
        INFO(run.err);
        CHECK(run.exit_code == 2);
        CHECK(contains(run.err,
                       "named.yaml:12:18: error: the grid './points.xyz' would overwrite "
                       "the file " +
                           named));
        CHECK(contains(run.err, "named.yaml:11:"));
        const auto outcome = nlohmann::json::parse(shop.read("outcome.json"));
        CHECK(outcome["exit_code"] == 2);
        CHECK(outcome["diagnostics"][0]["line"] == 12);
    }
    shop.refuses("run named.yaml -o points.xyz",
                 "-o 'points.xyz' would overwrite the file " + named);
    shop.refuses("run named.yaml -o y.cgns --json part.yaml",
                 "--json 'part.yaml' would overwrite the file 'part.yaml'");
    CHECK(shop.read("points.xyz") == points);
    CHECK(contains(shop.read("part.yaml"), "twice"));
    // Also where the config has errors.
    shop.write("wrong.yaml", tiny + "include: part.yaml\nspeling: 1\n");
    CHECK(shop.hexweave("check wrong.yaml --json part.yaml").exit_code == 2);
    CHECK(contains(shop.read("part.yaml"), "twice"));
}

TEST_CASE("a path that cannot be meant is wrong input in every command, told before the work") {
    const Workshop shop;
    const std::string none = "': no such folder 'none'";
    shop.refuses("run tiny.yaml --json none/y.json -o y.cgns", "cannot write 'none/y.json" + none);
    shop.refuses("run tiny.yaml -o none/y.cgns", "cannot write 'none/y.cgns" + none);
    shop.refuses("run tiny.yaml -o none/y.vtm", "cannot write 'none/y.vtm" + none);
    shop.refuses("run tiny.yaml --golden none", "no such folder 'none'");
    shop.refuses("check tiny.yaml --json none/y.json", none);
    shop.refuses("graph tiny.yaml -o none/y.svg", none);
    shop.refuses("quality grid.cgns --json none/y.json", none);
    shop.refuses("compare grid.cgns grid.cgns --json none/y.json", none);
    shop.refuses("convert grid.cgns none/y.xyz", none);
    shop.refuses("report grid.cgns -o none/y.html", none);
    shop.refuses("plot grid.cgns -o none/y.png", none);
    shop.refuses("init none/y", none);
    shop.refuses("run tiny.yaml -o y.cgns --json folder", "cannot write 'folder': it is a folder");
    fs::create_directory(shop.path() / "y.cgns");
    shop.refuses("run tiny.yaml -o y.cgns", "cannot write 'y.cgns': it is a folder");
    shop.refuses("run tiny.yaml -o run.json/case.foam", "'run.json': it is not a folder");
    shop.refuses("convert grid.cgns run.json --to openfoam", "'run.json': it is not a folder");
    shop.refuses("run tiny.yaml -o run.json/y.cgns", "'run.json' is not a folder");
}

TEST_CASE("every output of a config that cannot be written is told at its place, by check too") {
    const Scratch scratch;
    scratch.write("tiny.yaml",
                  tiny + "output:\n  cgns: none/a.cgns\n  vtk: other/a.vtm\n  openfoam: file\n");
    scratch.write("file", "");
    for (const char* command : {"run tiny.yaml", "check tiny.yaml"}) {
        const Finished run = scratch.hexweave(command);
        INFO(run.err);
        CHECK(run.exit_code == 2);
        CHECK(
            contains(run.err, "tiny.yaml:11:9: error: cannot write 'none/a.cgns': no such folder"));
        CHECK(
            contains(run.err, "tiny.yaml:12:8: error: cannot write 'other/a.vtm': no such folder"));
        CHECK(contains(run.err, "tiny.yaml:13:13: error: cannot write 'file': it is not a folder"));
        CHECK(run.out.empty());
        CHECK(scratch.listing() == "file tiny.yaml");
    }
    // Another place may be given.
    CHECK(scratch.hexweave("run tiny.yaml -o a.cgns").exit_code == 0);
}

TEST_CASE("a golden grid is told of in JSON, several are not") {
    const Workshop shop;
    shop.write("other.yaml", tiny + "parameters: {unused: 1}\n");
    shop.refuses("run --golden folder tiny.yaml other.yaml --json g.json",
                 "--json tells of one case");
    const Finished run = shop.hexweave("run --golden folder other.yaml --json -");
    INFO(run.err);
    CHECK(run.exit_code == 0);
    const auto outcome = nlohmann::json::parse(run.out);
    CHECK(outcome["config"] == "other.yaml");
    CHECK(outcome["outputs"] == nlohmann::json({"folder/other.cgns"}));
    CHECK(outcome["parameters"].size() == 1);
    CHECK(outcome["grids"].size() == 1);
    CHECK(outcome["diagnostics"].size() == 1);
}
