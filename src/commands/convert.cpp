// SPDX-License-Identifier: Apache-2.0
// hexweave convert IN OUT: a grid from one format to another.
#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "commands/command.h"
#include "io/grid_file.h"
#include "io/output_files.h"

namespace hexweave {
namespace {

struct ConvertArguments {
    std::string input;
    std::string output;
    std::string from;
    std::string to;
    std::string form;
    std::string byte_order;
};

const std::map<std::string, GridFormat> formats{{"cgns", GridFormat::cgns},
                                                {"plot3d", GridFormat::plot3d},
                                                {"vtk", GridFormat::vtk},
                                                {"openfoam", GridFormat::openfoam}};

GridOutput output_of(const ConvertArguments& arguments) {
    std::optional<GridOutput> output = output_by_name(arguments.output);
    if (!arguments.to.empty()) {
        if (!output) output = GridOutput{};
        output->format = formats.at(arguments.to);
        output->path = arguments.output;
    }
    if (!output) throw UsageError(unknown_ending(arguments.output));
    if (output->format == GridFormat::vtk &&
        !std::filesystem::path(arguments.output).has_extension()) {
        throw UsageError(
            fmt::format("cannot write '{0}': for VTK its name needs an ending, as in '{0}.vtm': a "
                        "folder beside "
                        "it has the name without",
                        arguments.output));
    }
    if (output->format != GridFormat::plot3d &&
        !(arguments.form.empty() && arguments.byte_order.empty())) {
        throw UsageError("--form and --byte-order are for Plot3D");
    }
    if (arguments.form == "text") output->form = Plot3dForm::text;
    if (arguments.form == "unformatted") output->form = Plot3dForm::unformatted;
    if (arguments.form == "stream") output->form = Plot3dForm::stream;
    if (output->form == Plot3dForm::text && !arguments.byte_order.empty()) {
        throw UsageError("--byte-order is for numbers as bytes: '" + arguments.output +
                         "' would hold them as text (--form)");
    }
    if (arguments.byte_order == "big") output->byte_order = ByteOrder::big;
    return *output;
}

/// Points alone say nothing of what joins and bounds the blocks.
void warn_of_missing_map(const std::vector<FileUse>& read) {
    for (const FileUse& use : read) {
        if (std::filesystem::exists(use.path)) continue;
        fmt::print(stderr,
                   "hexweave: warning: no map '{}' beside the grid: interfaces and boundaries are "
                   "unknown\n",
                   use.path.string());
    }
}

ExitCode convert(const ConvertArguments& arguments) {
    const GridOutput output = output_of(arguments);
    std::optional<GridFormat> from;
    if (!arguments.from.empty()) from = formats.at(arguments.from);
    const std::vector<FileUse> read = files_read(arguments.input, "the grid", from);
    require_apart({read, files_written(output, "OUT")});
    const MultiblockGrid grid = read_grid(arguments.input, from);
    warn_of_missing_map(read);
    OutputFiles files;
    const ReservedOutput reserved = reserve(output, files);
    write_grid(grid, reserved, files);
    files.commit();
    const std::size_t cells = std::accumulate(
        grid.zones.begin(), grid.zones.end(), std::size_t{0},
        [](std::size_t sum, const Zone& zone) { return sum + zone.points.extent().cells(); });
    fmt::print("wrote {} ({} zone{}, {} cells, {} interfaces, {} boundary patches)\n",
               arguments.output, grid.zones.size(), grid.zones.size() == 1 ? "" : "s", cells,
               grid.interfaces.size(), grid.patches.size());
    return ExitCode::done;
}

}  // namespace

void add_convert(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("convert", "write a grid in another format");
    const auto arguments = std::make_shared<ConvertArguments>();
    command
        ->add_option("IN", arguments->input,
                     "the grid: CGNS, or Plot3D with the map (.nmf) beside it")
        ->required();
    command
        ->add_option("OUT", arguments->output,
                     "the format is told by the ending: " + known_endings())
        ->required();
    command->add_option("--from", arguments->from, "the format of IN, whatever its name")
        ->check(CLI::IsMember({"cgns", "plot3d"}));
    command
        ->add_option("--to", arguments->to,
                     "the format of OUT, whatever its name; for openfoam OUT is the case's folder")
        ->check(CLI::IsMember({"cgns", "plot3d", "vtk", "openfoam"}));
    command
        ->add_option("--form", arguments->form,
                     "how a Plot3D file holds numbers (default: as its ending says)")
        ->check(CLI::IsMember({"text", "unformatted", "stream"}));
    command->add_option("--byte-order", arguments->byte_order, "of Plot3D (default: little)")
        ->check(CLI::IsMember({"little", "big"}));
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return convert(*arguments); }; });
}

}  // namespace hexweave
