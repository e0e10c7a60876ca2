// SPDX-License-Identifier: Apache-2.0
#include "topology/read_output.h"

#include <fmt/format.h>

#include <filesystem>

namespace hexweave {

namespace {

/// The path at `node`, when its ending is one of the format; tells what is not.
bool read_path(Reading& reading, const YamlNode& node, const std::string& what, GridFormat format,
               const std::string& endings, GridOutput& output) {
    const auto text = read_text(reading, node, what);
    if (!text) return false;
    const std::string ending = std::filesystem::path(*text).extension().string();
    if (!endings.empty() && format_of_ending(ending) != format) {
        reading.diagnostics.error(
            node.place, fmt::format("{} is '{}', without an ending of this format", what, *text),
            "the name must end in " + endings);
        return false;
    }
    output.format = format;
    output.path = *text;
    output.place = node.place;
    output.form = plot3d_form_of_ending(ending);
    return true;
}

/// FILE, or {file: FILE, form: text, byte_order: big}.
bool read_plot3d(Reading& reading, const YamlNode& node, GridOutput& output) {
    if (!node.is_mapping()) {
        return read_path(reading, node, "'plot3d'", GridFormat::plot3d, plot3d_endings(), output);
    }
    if (!expect_mapping(reading, node, "'plot3d'", "plot3d_output")) return false;
    const YamlNode* file = require(reading, node, "file", "'plot3d'");
    const bool named = file != nullptr && read_path(reading, *file, "'file'", GridFormat::plot3d,
                                                    plot3d_endings(), output);
    if (const YamlNode* form = find(reading, node, "form")) {
        const auto choice =
            read_choice(reading, *form, "'form'", words_of("plot3d_output", "form"));
        if (choice) output.form = static_cast<Plot3dForm>(*choice);
    }
    if (const YamlNode* order = find(reading, node, "byte_order")) {
        const auto choice =
            read_choice(reading, *order, "'byte_order'", words_of("plot3d_output", "byte_order"));
        if (choice) output.byte_order = static_cast<ByteOrder>(*choice);
    }
    return named;
}

}  // namespace

std::vector<GridOutput> read_output(Reading& reading, const YamlNode* section) {
    std::vector<GridOutput> outputs;
    if (section == nullptr) return outputs;
    expect_mapping(reading, *section, "'output'", "output");
    GridOutput output;
    if (const YamlNode* cgns = find(reading, *section, "cgns")) {
        if (read_path(reading, *cgns, "'cgns'", GridFormat::cgns, ".cgns", output)) {
            outputs.push_back(output);
        }
    }
    if (const YamlNode* plot3d = find(reading, *section, "plot3d")) {
        GridOutput with_form;
        if (read_plot3d(reading, *plot3d, with_form)) outputs.push_back(with_form);
    }
    if (const YamlNode* vtk = find(reading, *section, "vtk")) {
        if (read_path(reading, *vtk, "'vtk'", GridFormat::vtk, ".vtm", output)) {
            outputs.push_back(output);
        }
    }
    if (const YamlNode* openfoam = find(reading, *section, "openfoam")) {
        if (read_path(reading, *openfoam, "'openfoam'", GridFormat::openfoam, "", output)) {
            outputs.push_back(output);
        }
    }
    return outputs;
}

}  // namespace hexweave
