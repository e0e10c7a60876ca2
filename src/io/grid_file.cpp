// SPDX-License-Identifier: Apache-2.0
#include "io/grid_file.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string_view>

#include "core/errors.h"
#include "core/grid_output.h"
#include "io/cgns.h"
#include "io/neutral_map.h"
#include "io/plot3d.h"

namespace hexweave {
namespace {

/// Whether the file begins as HDF5 or ADF files do, whatever it is called.
bool begins_as_cgns(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::array<char, 64> start{};
    stream.read(start.data(), start.size());
    const std::string_view text(start.data(), static_cast<std::size_t>(stream.gcount()));
    return text.starts_with("\x89HDF\r\n") || text.find("ADF Database") != std::string_view::npos;
}

GridFormat format_to_read(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    const auto format = format_of_ending(ending);
    if (format) return *format;
    if (begins_as_cgns(path)) return GridFormat::cgns;
    throw UsageError(
        fmt::format("cannot read '{}': its format is not known by its ending '{}' "
                    "({})",
                    path.string(), ending, known_endings()));
}

MultiblockGrid read_plot3d_and_map(const std::filesystem::path& path) {
    MultiblockGrid grid = read_plot3d(path);
    std::filesystem::path map = path;
    map.replace_extension(".nmf");
    if (std::filesystem::exists(map)) read_neutral_map(map, grid);
    return grid;
}

}  // namespace

MultiblockGrid read_grid(const std::filesystem::path& path, std::optional<GridFormat> format) {
    switch (format ? *format : format_to_read(path)) {
        case GridFormat::cgns:
            return read_cgns(path);
        case GridFormat::plot3d:
            return read_plot3d_and_map(path);
        case GridFormat::vtk:
        case GridFormat::openfoam:
            break;
    }
    throw UsageError(
        fmt::format("cannot read '{}': hexweave writes this format and reads CGNS and "
                    "Plot3D",
                    path.string()));
}

}  // namespace hexweave
