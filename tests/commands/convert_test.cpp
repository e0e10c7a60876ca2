// SPDX-License-Identifier: Apache-2.0
// Grids in other formats: asked for in the config, with -o, and made by `convert`.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/commands/program.h"

using namespace hexweave::testing;

namespace {

const std::string square = R"(hexweave: 1
vertices: {a: [0, 0], b: [1, 0], c: [1, 1], d: [0, 1], e: [2, 0], f: [2, 1]}
edges:
  south: {from: a, to: b, cells: 4}
  east:  {from: b, to: e, cells: 2}
  west:  {from: a, to: d, cells: 3}
faces:
  left:  {corners: [a, b, c, d]}
  right: {corners: [b, e, f, c]}
boundaries:
  rim: {type: BCWall, sides: [south, east, west, e-f, c-d, c-f]}
)";

}  // namespace

TEST_CASE("a config may ask for several formats at once") {
    const Scratch scratch;
    scratch.write("square.yaml", square +
                                     "output: {cgns: s.cgns, plot3d: {file: s.xyz, form: "
                                     "stream, byte_order: big}, vtk: s.vtm, openfoam: foam}\n");
    const Finished run = scratch.hexweave("run square.yaml --json outcome.json");
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    CHECK(contains(run.out, "wrote s.cgns, s.xyz, s.vtm, foam in "));
    CHECK(scratch.listing() == "foam outcome.json s s.cgns s.nmf s.vtm s.xyz square.yaml");
    for (const char* name : {"points", "faces", "owner", "neighbour", "boundary"}) {
        CHECK(scratch.has(std::string("foam/constant/polyMesh/") + name));
    }
    for (const char* name : {"zone1.vts", "zone2.vts", "patch1.vts", "patch6.vts"}) {
        CHECK(scratch.has(std::string("s/") + name));
    }
    CHECK(scratch.read("s.xyz").substr(0, 8) == std::string("\0\0\0\2\0\0\0\5", 8));
    const auto outcome = nlohmann::json::parse(scratch.read("outcome.json"));
    CHECK(outcome["outputs"] == nlohmann::json({"s.cgns", "s.xyz", "s.vtm", "foam"}));
}

TEST_CASE("the option -o tells formats by their endings and replaces what the config says") {
    const Scratch scratch;
    scratch.write("square.yaml", square + "output: {cgns: s.cgns}\n");
    const Finished run = scratch.hexweave("run square.yaml -o s.p3d -o case/case.foam");
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    CHECK(scratch.listing() == "case s.nmf s.p3d square.yaml");
    CHECK(scratch.read("s.p3d").substr(0, 10) == "2\n5 4\n3 4\n");
    CHECK(scratch.read("case/case.foam").empty());
    const Finished twice = scratch.hexweave("run square.yaml -o t.cgns -o t.cgns");
    CHECK(twice.exit_code == 2);
    CHECK(contains(twice.err, "two outputs would be written to 't.cgns'"));
}

TEST_CASE("convert goes from CGNS to Plot3D and back to the same file") {
    const Scratch scratch;
    scratch.write("square.yaml", square);
    REQUIRE(scratch.hexweave("run --quiet square.yaml").exit_code == 0);
    for (const char* form : {"text", "unformatted", "stream"}) {
        const Finished there =
            scratch.hexweave("convert square.cgns s.xyz --form " + std::string(form) +
                             (form == std::string("text") ? "" : " --byte-order big"));
        INFO(there.err);
        CHECK(there.exit_code == 0);
        CHECK(there.out == "wrote s.xyz (2 zones, 18 cells, 1 interfaces, 6 boundary patches)\n");
        REQUIRE(scratch.hexweave("convert s.xyz back.cgns").exit_code == 0);
        CHECK(scratch.read("back.cgns") == scratch.read("square.cgns"));
    }
    CHECK(scratch.hexweave("convert s.xyz other --from plot3d --to cgns").exit_code == 0);
    CHECK(scratch.read("other") == scratch.read("square.cgns"));
    CHECK(scratch.hexweave("plot s.xyz -o s.png").exit_code == 0);
}

TEST_CASE("convert says what it cannot do, and leaves nothing behind") {
    const Scratch scratch;
    scratch.write("square.yaml", square);
    scratch.write("text.cgns", "this is no grid");
    scratch.write("cut.p3d", "2\n5 4\n3 4\n0 0.25 0.5\n");
    REQUIRE(scratch.hexweave("run --quiet square.yaml").exit_code == 0);
    const std::string before = scratch.listing();
    const auto refused = [&scratch](const std::string& arguments, const std::string& message) {
        const Finished convert = scratch.hexweave("convert " + arguments);
        INFO(arguments << ": " << convert.err);
        CHECK(convert.exit_code == 2);
        CHECK(contains(convert.err, message));
        CHECK(convert.out.empty());
    };
    refused("square.cgns grid.txt", "cannot write 'grid.txt': its format is not known");
    refused("square.cgns grid.vtm --form text", "are for Plot3D");
    refused("square.cgns grid.xyz --form text --byte-order big",
            "'grid.xyz' would hold them as text");
    refused("square.cgns grid.p3d --byte-order little", "'grid.p3d' would hold them as text");
    refused("square.cgns grid --to vtk",
            "cannot write 'grid': for VTK its name needs an ending, as in 'grid.vtm'");
    refused("grid.vtm grid.cgns",
            "cannot read 'grid.vtm': hexweave writes this format and reads CGNS and Plot3D");
    refused("grid.json grid.cgns", ".xyz, .x, .g, .grd, .ufmt)");
    scratch.write("cut.cgns", scratch.read("square.cgns").substr(0, 3000));
    refused("cut.cgns grid.xyz", "cannot read 'cut.cgns': it is damaged or cut short");
    CHECK(scratch.shell("rm cut.cgns").exit_code == 0);
    refused("square.cgns", "OUT is required");
    refused("missing.cgns grid.xyz", "cannot read 'missing.cgns': no such file");
    refused("text.cgns grid.xyz", "not a CGNS file");
    refused("cut.p3d grid.cgns", "does not agree with the sizes");
    refused("square.yaml grid.cgns",
            "'square.yaml' is a config, not a grid; 'hexweave run square.yaml' makes its grid");
    const Finished no_folder = scratch.hexweave("convert square.cgns none/grid.vtm");
    CHECK(no_folder.exit_code == 2);
    CHECK(contains(no_folder.err, "no such folder 'none'"));
    scratch.write("surface.p3d", "1\n2 2 1\n0 1 0 1\n0 0 1 1\n0 0 0 1\n");
    refused("surface.p3d case --to openfoam", "a surface in space");
    CHECK(scratch.shell("rm surface.p3d").exit_code == 0);
    CHECK(scratch.listing() == before);
}

TEST_CASE("a Plot3D file without its map is converted with a warning") {
    const Scratch scratch;
    scratch.write("lonely.p2d", "1\n3 2\n0 1 2 0 1 2\n0 0 0 1 1 1\n");
    const Finished convert = scratch.hexweave("convert lonely.p2d lonely.cgns");
    CHECK(convert.exit_code == 0);
    CHECK(convert.err ==
          "hexweave: warning: no map 'lonely.nmf' beside the grid: interfaces and boundaries are "
          "unknown\n");
}
