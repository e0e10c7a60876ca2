// SPDX-License-Identifier: Apache-2.0
// `hexweave quality GRID`: judges any structured grid.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "commands/case_options.h"
#include "commands/command.h"
#include "core/parallel.h"
#include "core/processors.h"
#include "io/grid_file.h"
#include "io/quality_json.h"
#include "io/quality_text.h"
#include "quality/grid_quality.h"

namespace hexweave {

namespace {

struct QualityArguments {
    std::string grid;
    std::string json;
    int worst = 10;
    int threads = 0;
};

ExitCode tell_quality(const QualityArguments& arguments) {
    set_threads(choose_threads(arguments.threads));
    require_apart(files_read(arguments.grid, "the grid"), arguments.json);
    MultiblockGrid grid = read_grid(arguments.grid);
    name_sides_where_nothing_is_named(grid);
    const GridQuality quality = measure_quality(grid, arguments.worst);
    if (arguments.json != "-") std::fputs(to_text(quality).c_str(), stdout);
    if (!arguments.json.empty()) write_json_text(to_json(quality, arguments.grid), arguments.json);
    return quality.sound() ? ExitCode::done : ExitCode::not_sound;
}

}  // namespace

void add_quality(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("quality", "judge a structured grid, whoever made it");
    const auto arguments = std::make_shared<QualityArguments>();
    command->add_option("GRID", arguments->grid, "the grid: a structured CGNS or Plot3D file")
        ->required();
    command->add_option("--json", arguments->json,
                        "write the measures as JSON to this file; - prints it alone");
    command->add_option("--worst", arguments->worst, "how many of the worst cells to list")
        ->check(CLI::Range(0, 1000000))
        ->capture_default_str();
    add_threads_option(*command, arguments->threads);
    command->footer(
        "\nExit codes: 0 sound; 1 a cell is folded, or an interface differs on its two sides; 2 "
        "the\nfile or the command line is wrong; 3 the machine failed.");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return tell_quality(*arguments); }; });
}

}  // namespace hexweave
