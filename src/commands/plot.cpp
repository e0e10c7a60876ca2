// SPDX-License-Identifier: Apache-2.0
#include "commands/plot.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <memory>
#include <optional>
#include <string_view>

#include "commands/command.h"
#include "core/diagnostics.h"
#include "io/grid_file.h"
#include "io/output_files.h"

namespace hexweave {

namespace {

/// The whole text as a number, or nothing.
template <class Number>
std::optional<Number> number(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// "1200x900".
void read_size(const std::string& text, PictureOptions& options) {
    const auto parts = split(text, 'x');
    const auto width = number<int>(parts[0]);
    const auto height = parts.size() == 2 ? number<int>(parts[1]) : std::nullopt;
    if (!width || !height) {
        throw UsageError("--size " + text + ": a size is WIDTHxHEIGHT in pixels, as in 1200x900");
    }
    options.width = *width;
    options.height = *height;
}

/// "1,-1,0.8".
std::optional<Vec3> read_direction(const std::string& text) {
    const auto parts = split(text, ',');
    if (parts.size() != 3) return std::nullopt;
    const auto x = number<double>(parts[0]);
    const auto y = number<double>(parts[1]);
    const auto z = number<double>(parts[2]);
    if (!x || !y || !z) return std::nullopt;
    return Vec3{*x, *y, *z};
}

Vec3 read_view(const std::string& text) {
    if (text == "top") return {0, 0, 1};
    if (text == "front") return {0, -1, 0};
    if (text == "side") return {1, 0, 0};
    if (text == "iso") return isometric_view;
    if (const auto direction = read_direction(text)) return *direction;
    const std::string meant = nearest_name(text, {"top", "front", "side", "iso"});
    throw UsageError("--view " + text + ": a view is top, front, side, iso or X,Y,Z" +
                     (meant.empty() ? "" : "; did you mean '" + meant + "'?"));
}

}  // namespace

IndexPlane read_plane(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    const std::string_view rest =
        colon == std::string::npos ? "" : std::string_view(text).substr(colon + 1);
    const std::string_view axes = "ijk";
    const std::size_t axis = rest.empty() ? std::string_view::npos : axes.find(rest[0]);
    const auto index =
        rest.size() > 2 && rest[1] == '=' ? number<int>(rest.substr(2)) : std::nullopt;
    if (colon == 0 || axis == std::string_view::npos || !index) {
        throw UsageError("--plane " + text +
                         ": an index plane is ZONE:k=3 (or i, j), '*:k=3' for every zone");
    }
    const std::string zone = text.substr(0, colon);
    return {zone == "*" ? "" : zone, static_cast<int>(axis), *index - 1};
}

PictureOptions picture_options(const PlotArguments& arguments) {
    PictureOptions options;
    read_size(arguments.size, options);
    options.colour = arguments.colour == "family" ? ColourBy::family : ColourBy::zone;
    if (arguments.window.size() == 4) {
        const auto& w = arguments.window;
        options.window = std::array{w[0], w[1], w[2], w[3]};
    }
    if (!arguments.view.empty()) options.view = read_view(arguments.view);
    if (!arguments.up.empty()) {
        options.up = read_direction(arguments.up);
        if (!options.up) throw UsageError("--up " + arguments.up + ": a direction is X,Y,Z");
    }
    for (const std::string& plane : arguments.planes) options.planes.push_back(read_plane(plane));
    options.boundary = !arguments.no_boundary;
    options.families = arguments.families;
    options.title = arguments.title;
    return options;
}

ExitCode plot(const PlotArguments& arguments) {
    const PictureFormat format = picture_format(arguments.output);
    const PictureOptions options = picture_options(arguments);
    require_apart({files_read(arguments.grid, "the grid"), {{"-o", arguments.output}}});
    const MultiblockGrid grid = read_grid(arguments.grid);
    OutputFiles files;
    PictureSummary shown;
    files.write(files.stage(arguments.output), [&](const std::filesystem::path& temporary) {
        shown = draw_picture(grid, options, format, temporary);
    });
    files.commit();
    const std::string line = fmt::format(
        "wrote {} ({} x {}, {} zone{}, window {:.5g} {:.5g} {:.5g} {:.5g})\n", arguments.output,
        options.width, options.height, shown.zones, shown.zones == 1 ? "" : "s", shown.window[0],
        shown.window[1], shown.window[2], shown.window[3]);
    std::fputs(line.c_str(), stdout);
    return ExitCode::done;
}

void add_plot(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("plot", "draw a picture of a grid");
    const auto arguments = std::make_shared<PlotArguments>();
    command->add_option("GRID", arguments->grid, "the grid: a structured CGNS or a Plot3D file")
        ->required();
    command
        ->add_option("-o,--output", arguments->output,
                     "the picture: a name that ends in .png or .svg")
        ->required();
    command->add_option("--size", arguments->size, "width and height in pixels")
        ->type_name("WxH")
        ->capture_default_str();
    command
        ->add_option("--window", arguments->window,
                     "show this part of the view's plane only; the line printed at the end has "
                     "the form")
        ->expected(4)
        ->type_name("XMIN YMIN XMAX YMAX");
    command
        ->add_option("--view", arguments->view,
                     "from where to look: top (from +z), front (from -y), side (from +x), iso, or "
                     "a direction X,Y,Z")
        ->type_name("VIEW");
    command->add_option("--up", arguments->up, "the direction that points up in the picture")
        ->type_name("X,Y,Z");
    command
        ->add_option("--plane", arguments->planes,
                     "draw an index plane, nodes counted from 1: wing:k=3, or '*:k=3' for every "
                     "zone; may be repeated")
        ->allow_extra_args(false)
        ->type_name("ZONE:AXIS=N");
    command->add_option("--color,--colour", arguments->colour, "what the colours tell apart")
        ->check(CLI::IsMember({"zone", "family"}))
        ->capture_default_str();
    command
        ->add_option("--family", arguments->families,
                     "draw only the boundaries of this family; may be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME");
    command->add_flag("--no-boundary", arguments->no_boundary, "draw no boundaries");
    command->add_option("--title", arguments->title, "a line of text above the picture");
    command->callback([arguments, &chosen] { chosen = [arguments] { return plot(*arguments); }; });
}

}  // namespace hexweave
