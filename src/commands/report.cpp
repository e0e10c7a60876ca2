// SPDX-License-Identifier: Apache-2.0
// `hexweave report GRID -o PAGE`: one page to look at.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "commands/case_options.h"
#include "commands/command.h"
#include "commands/plot.h"
#include "core/parallel.h"
#include "core/processors.h"
#include "io/grid_file.h"
#include "io/html_report.h"
#include "io/output_files.h"
#include "io/run_of_grid.h"
#include "io/text_parts.h"
#include "quality/grid_quality.h"

namespace hexweave {

namespace {

struct ReportArguments {
    std::string grid;
    std::string output;
    std::string run;
    std::vector<std::string> planes;
    int worst = 10;
    int threads = 0;
};

std::string missed_text(std::size_t gates) {
    return gates == 0 ? "" : "; " + counted(gates, "gate") + " missed in the run";
}

ExitCode write_report(const ReportArguments& arguments) {
    set_threads(choose_threads(arguments.threads));
    HtmlReportOptions options;
    options.grid_file = std::filesystem::path(arguments.grid).filename().string();
    for (const std::string& plane : arguments.planes) options.planes.push_back(read_plane(plane));
    FileUses uses{files_read(arguments.grid, "the grid"), {{"-o", arguments.output}}};
    if (!arguments.run.empty()) uses.read.push_back({"--run", arguments.run});
    require_apart(uses);
    const std::string run = arguments.run.empty() ? "" : read_whole_file(arguments.run);
    OutputFiles files;
    const std::filesystem::path staged = files.stage(arguments.output);
    MultiblockGrid grid = read_grid(arguments.grid);
    RunOfGrid told;
    if (!arguments.run.empty()) told = run_of_grid(run, arguments.run, grid);
    options.run = told.json;
    name_sides_where_nothing_is_named(grid);
    const GridQuality quality = measure_quality(grid, arguments.worst);
    const std::string page = html_report(grid, quality, options);
    files.write(staged, [&page](const auto& temporary) { write_text(page, temporary); });
    files.commit();
    fmt::print("wrote {} ({:.1f} MB): {}{}\n", arguments.output,
               static_cast<double>(page.size()) / 1e6, quality.sound() ? "sound" : "NOT SOUND",
               missed_text(told.missed_gates));
    return quality.sound() ? ExitCode::done : ExitCode::not_sound;
}

}  // namespace

void add_report(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("report", "write one page to look at a grid with");
    const auto arguments = std::make_shared<ReportArguments>();
    command->add_option("GRID", arguments->grid, "the grid: a structured CGNS or Plot3D file")
        ->required();
    command->add_option("-o,--output", arguments->output, "the page: one HTML file")
        ->required()
        ->type_name("FILE.html");
    command
        ->add_option("--run", arguments->run,
                     "what 'hexweave run --json' wrote of it: its gates and parameters are shown")
        ->type_name("FILE.json");
    command
        ->add_option("--plane", arguments->planes,
                     "have this index plane in the page besides those chosen: wing:k=3, or "
                     "'*:k=3' for every zone; may be repeated")
        ->allow_extra_args(false)
        ->type_name("ZONE:AXIS=N");
    command->add_option("--worst", arguments->worst, "how many of the worst cells to list")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    add_threads_option(*command, arguments->threads);
    command->footer(
        "\nExit codes: 0 the grid is sound; 1 it is not (the page is written); 2 a file or the "
        "command\nline is wrong; 3 the machine failed.");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return write_report(*arguments); }; });
}

}  // namespace hexweave
