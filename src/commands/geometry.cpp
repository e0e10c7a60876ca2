// SPDX-License-Identifier: Apache-2.0
// hexweave geometry FILE: what a CAD file holds.
#include "io/geometry_text.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "commands/case_options.h"
#include "commands/command.h"
#include "geometry/cad.h"

namespace hexweave {
namespace {

struct GeometryArguments {
    std::string file;
    std::string json;
    bool edges = false;
};

ExitCode list_geometry(const GeometryArguments& arguments) {
    require_apart({{"the file", arguments.file}}, arguments.json);
    const auto source = read_source(arguments.file);
    if (!can_read_cad()) {
        throw UsageError(
            "this hexweave was built without Open CASCADE, which reads CAD files; build it with "
            "-DHEXWEAVE_CAD=ON");
    }
    const CadResult result = read_cad(source->text);
    if (!result.file) throw UsageError("cannot read '" + source->name + "': " + result.error);
    if (!arguments.json.empty()) {
        write_json_text(to_json(*result.file, source->name), arguments.json);
    }
    if (arguments.json == "-") return ExitCode::done;
    std::fputs(to_text(*result.file, source->name, arguments.edges).c_str(), stdout);
    return ExitCode::done;
}

}  // namespace

void add_geometry(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand(
        "geometry",
        "list the surfaces and curves of a CAD file (IGES, STEP): number, label, name, type, "
        "parameter ranges, box, unit");
    const auto arguments = std::make_shared<GeometryArguments>();
    command->add_option("FILE", arguments->file, "the IGES or STEP file; - reads standard input")
        ->required();
    command->add_flag("--edges", arguments->edges,
                      "list the edges of every surface as well, with their end points");
    command
        ->add_option("--json", arguments->json,
                     "write the list as JSON, edges included, to this file; - prints it instead")
        ->type_name("FILE");
    command->footer(
        "A case uses them by number, label or name:\n"
        "  surfaces: {wing: {cad: FILE, entity: 3}}\n"
        "  curves:   {root: {cad: FILE, entity: 3, edge: 1}}");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return list_geometry(*arguments); }; });
}

}  // namespace hexweave
