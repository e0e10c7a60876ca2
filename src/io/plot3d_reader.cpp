// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>

#include "core/errors.h"
#include "io/output_place.h"
#include "io/plot3d.h"
#include "io/plot3d_source.h"

namespace hexweave {
namespace {

/// Text has no control characters but white space, bytes nearly always have zeros.
bool looks_like_text(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::array<char, 4096> start{};
    stream.read(start.data(), start.size());
    return std::all_of(start.data(), start.data() + stream.gcount(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return (byte >= ' ' && byte <= '~') || c == '\n' || c == '\r' || c == '\t';
    });
}

void require_file(const std::filesystem::path& path) {
    struct stat status = {};
    if (stat(path.c_str(), &status) != 0) {
        cannot_read(path, errno == ENOENT ? "no such file" : error_reason(errno));
    }
    if (S_ISDIR(status.st_mode)) cannot_read(path, "it is a folder");
    if (!S_ISREG(status.st_mode)) cannot_read(path, "it is not a regular file");
    if (access(path.c_str(), R_OK) != 0) cannot_read(path, error_reason(errno));
    if (status.st_size == 0) cannot_read(path, "it is empty");
}

}  // namespace

void cannot_read(const std::filesystem::path& path, const std::string& fact) {
    throw UsageError(fmt::format("cannot read '{}': {}", path.string(), fact));
}

void fits_no_layout(const std::filesystem::path& path) {
    cannot_read(path,
                "it is not a Plot3D grid, or it is damaged: its length does not agree with the "
                "sizes at its beginning");
}

void has_holes(const std::filesystem::path& path, const std::string& zone) {
    cannot_read(path,
                fmt::format("zone '{}' has points blanked out; hexweave reads whole blocks", zone));
}

MultiblockGrid empty_grid(const std::filesystem::path& path, const Plot3dLayout& layout) {
    MultiblockGrid grid;
    grid.physical_dimension = layout.dimension;
    const auto is_flat = [](const Extent& extent) { return extent.nk == 1; };
    const auto flat = std::count_if(layout.extents.begin(), layout.extents.end(), is_flat);
    grid.cell_dimension = flat > 0 ? 2 : 3;
    if (flat > 0 && flat < static_cast<std::ptrdiff_t>(layout.extents.size())) {
        cannot_read(path, "some of its blocks are one node thick and some are not");
    }
    const std::size_t digits = std::to_string(layout.extents.size()).size();
    for (const Extent& extent : layout.extents) {
        const std::string name = fmt::format("block{:0{}}", grid.zones.size() + 1, digits);
        if (extent.ni < 2 || extent.nj < 2) {
            cannot_read(path, fmt::format("zone '{}' is {} nodes in a row, no surface or block",
                                          name, extent.nodes()));
        }
        grid.zones.push_back({name, {}});
    }
    return grid;
}

MultiblockGrid read_plot3d(const std::filesystem::path& path) {
    require_file(path);
    return looks_like_text(path) ? read_plot3d_text(path) : read_plot3d_bytes(path);
}

}  // namespace hexweave
