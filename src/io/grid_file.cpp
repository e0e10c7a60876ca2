// SPDX-License-Identifier: Apache-2.0
#include "io/grid_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "core/errors.h"
#include "core/grid_output.h"
#include "io/byte_writer.h"
#include "io/cgns.h"
#include "io/neutral_map.h"
#include "io/openfoam.h"
#include "io/plot3d.h"
#include "io/poly_mesh.h"
#include "io/vtk.h"

namespace hexweave {
namespace {

std::string unknown_ending(const char* verb, const std::filesystem::path& path,
                           const std::string& endings) {
    return fmt::format("cannot {} '{}': its format is not known by its ending '{}' ({})", verb,
                       path.string(), path.extension().string(), endings);
}

std::filesystem::path map_beside(std::filesystem::path path) {
    return path.replace_extension(".nmf");
}

MultiblockGrid read_plot3d_and_map(const std::filesystem::path& path) {
    MultiblockGrid grid = read_plot3d(path);
    const std::filesystem::path map = map_beside(path);
    if (std::filesystem::exists(map)) read_neutral_map(map, grid);
    return grid;
}

/// Throws UsageError, naming the first node that is none.
void require_numbers(const MultiblockGrid& grid, const std::filesystem::path& path) {
    for (const Zone& zone : grid.zones) {
        const Extent& e = zone.points.extent();
        for (std::size_t n = 0; n < e.nodes(); ++n) {
            if (is_finite(zone.points[n])) continue;
            const auto ni = static_cast<std::size_t>(e.ni);
            const auto nj = static_cast<std::size_t>(e.nj);
            throw UsageError(fmt::format(
                "cannot read '{}': node ({}, {}, {}) of zone '{}' has a coordinate "
                "that is not a finite number",
                path.string(), n % ni + 1, n / ni % nj + 1, n / ni / nj + 1, zone.name));
        }
    }
}

constexpr const char* foam_ending = ".foam";

bool names_marker(const std::filesystem::path& path) {
    return path.extension() == foam_ending;
}

/// The folder of the case, those in it down to that of the mesh, and what stands there.
std::vector<FileUse> files_of_case(const std::filesystem::path& path, const std::string& role) {
    std::filesystem::path folder = names_marker(path) ? path.parent_path() : path;
    if (folder.empty()) folder = ".";
    if (!folder.has_filename()) folder = folder.parent_path();  // "case/"
    std::vector<FileUse> uses{{role, folder, {}, FileUse::Kind::folder}};
    for (const char* inner : {"constant", "polyMesh"}) {
        folder /= inner;
        uses.push_back({"a folder of " + role, folder, {}, FileUse::Kind::folder});
    }
    for (const char* name : poly_mesh_files) uses.push_back({"a file of " + role, folder / name});
    if (names_marker(path)) uses.push_back({role, path});
    return uses;
}

std::filesystem::path vtk_folder(std::filesystem::path path) {
    return path.replace_extension();
}

void write_vtk(const MultiblockGrid& grid, const ReservedOutput& reserved, OutputFiles& files) {
    const std::filesystem::path folder = vtk_folder(reserved.output.path);
    const std::vector<VtkPiece> pieces = vtk_pieces(grid);
    for (const VtkPiece& piece : pieces) {
        files.write(files.stage(folder / piece.file),
                    [&](const auto& path) { write_vtk_piece(grid, piece, path); });
    }
    files.write(reserved.staged[0], [&](const auto& path) {
        write_vtk_index(grid, pieces, folder.filename().string(), path);
    });
}

void write_openfoam(const MultiblockGrid& grid, const ReservedOutput& reserved,
                    const OutputFiles& files) {
    const PolyMesh mesh = make_poly_mesh(grid);
    std::array<std::filesystem::path, poly_mesh_files.size()> paths;
    std::copy_n(reserved.staged.begin(), paths.size(), paths.begin());
    files.write(paths[0], [&](const auto&) { write_poly_mesh(mesh, paths); });
}

}  // namespace

bool file_begins_as_cgns(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::array<char, 64> start{};
    stream.read(start.data(), start.size());
    return begins_as_cgns({start.data(), static_cast<std::size_t>(stream.gcount())});
}

GridFormat format_to_read(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    const auto format = format_of_ending(ending);
    if (format) return *format;
    if (file_begins_as_cgns(path)) return GridFormat::cgns;
    if (ending == ".yaml" || ending == ".yml") {
        throw UsageError(fmt::format(
            "'{0}' is a config, not a grid; 'hexweave run {0}' makes its grid", path.string()));
    }
    throw UsageError(unknown_ending("read", path, ".cgns; Plot3D: " + plot3d_endings()));
}

bool begins_as_cgns(std::string_view text) {
    return text.starts_with("\x89HDF\r\n") ||
           text.substr(0, 64).find("ADF Database") != std::string_view::npos;
}

std::string unknown_ending(const std::string& path) {
    return unknown_ending("write", path, known_endings());
}

std::optional<GridOutput> output_by_name(const std::string& path) {
    const std::string ending = std::filesystem::path(path).extension().string();
    const auto format = format_of_ending(ending);
    if (!format) return std::nullopt;
    return GridOutput{*format, path, plot3d_form_of_ending(ending)};
}

std::vector<FileUse> files_written(const GridOutput& output, const std::string& role) {
    const std::filesystem::path path = output.path;
    std::vector<FileUse> uses{{role, path}};
    switch (output.format) {
        case GridFormat::cgns:
            break;
        case GridFormat::plot3d:
            uses.push_back({"the map of " + role, map_beside(path)});
            break;
        case GridFormat::vtk:
            uses.push_back({"the folder of " + role, vtk_folder(path), {}, FileUse::Kind::pieces});
            break;
        case GridFormat::openfoam:
            uses = files_of_case(path, role);
            break;
    }
    for (FileUse& use : uses) use.place = output.place;
    return uses;
}

std::vector<FileUse> files_read(const std::filesystem::path& path, const std::string& role,
                                std::optional<GridFormat> format) {
    std::vector<FileUse> uses{{role, path}};
    if (!format) format = format_of_ending(path.extension().string());
    if (format == GridFormat::plot3d) uses.push_back({"the map of " + role, map_beside(path)});
    return uses;
}

ReservedOutput reserve(const GridOutput& output, OutputFiles& files) {
    ReservedOutput reserved{output, {}};
    for (const FileUse& use : files_written(output, "the grid")) {
        if (use.kind == FileUse::Kind::file) {
            reserved.staged.push_back(files.stage(use.path));
        } else {
            files.make_folder(use.path);
        }
    }
    return reserved;
}

void write_grid(const MultiblockGrid& grid, const ReservedOutput& reserved, OutputFiles& files) {
    const GridOutput& output = reserved.output;
    switch (output.format) {
        case GridFormat::cgns:
            files.write(reserved.staged[0], [&](const auto& path) { write_cgns(grid, path); });
            break;
        case GridFormat::plot3d:
            files.write(reserved.staged[0], [&](const auto& path) {
                write_plot3d(grid, path, output.form, output.byte_order);
            });
            files.write(reserved.staged[1],
                        [&](const auto& path) { write_neutral_map(grid, path); });
            break;
        case GridFormat::vtk:
            write_vtk(grid, reserved, files);
            break;
        case GridFormat::openfoam:
            write_openfoam(grid, reserved, files);
            break;
    }
}

MultiblockGrid read_grid(const std::filesystem::path& path, std::optional<GridFormat> format) {
    MultiblockGrid grid;
    switch (format ? *format : format_to_read(path)) {
        case GridFormat::cgns:
            grid = read_cgns(path);
            break;
        case GridFormat::plot3d:
            grid = read_plot3d_and_map(path);
            break;
        case GridFormat::vtk:
        case GridFormat::openfoam:
            throw UsageError(
                fmt::format("cannot read '{}': hexweave writes this format and reads CGNS and "
                            "Plot3D",
                            path.string()));
    }
    require_numbers(grid, path);
    return grid;
}

}  // namespace hexweave
