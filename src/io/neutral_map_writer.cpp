// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdlib>

#include "core/errors.h"
#include "core/interface_sides.h"
#include "io/byte_writer.h"
#include "io/neutral_map.h"
#include "io/neutral_map_faces.h"

namespace hexweave {
namespace {

[[noreturn]] void cannot_hold(const std::string& fact) {
    throw UsageError(fmt::format("a neutral map file cannot hold this grid: {}", fact));
}

/// One line of text, whatever was in it.
std::string on_one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    return text;
}

/// A family's name as the type of an entry, quoted where it is not one word.
std::string entry_type(const std::string& name) {
    const std::string word = map_word(name);
    if (name.empty() || word == "ONE_TO_ONE" || word == "PATCHED" ||
        name.find_first_of("'\"\n\r\t") != std::string::npos) {
        cannot_hold(fmt::format("a family cannot be called '{}' there", name));
    }
    return name.find_first_of(" ,#\\") == std::string::npos ? name : "'" + name + "'";
}

/// The number of the face of the zone that a box lies in.
std::size_t face_number(const IndexBox& box, const Zone& zone, int cell_dimension,
                        const std::string& what) {
    for (std::size_t number = 0; number < map_faces.size(); ++number) {
        const int axis = axis_of(map_faces[number].side);
        if (axis >= cell_dimension) continue;
        const auto a = static_cast<std::size_t>(axis);
        const int place = is_max(map_faces[number].side) ? zone.points.extent()[axis] - 1 : 0;
        if (box.begin[a] == place && box.end[a] == place) return number + 1;
    }
    cannot_hold(fmt::format("{} lies in no face of zone '{}'", what, zone.name));
}

std::string range_text(std::size_t zone, std::size_t face, const IndexBox& box) {
    const MapFace& in = map_faces[face - 1];
    return fmt::format(" {:>5} {:>3} {:>6} {:>6} {:>6} {:>6}", zone + 1, face,
                       box.begin[in.primary] + 1, box.end[in.primary] + 1,
                       box.begin[in.secondary] + 1, box.end[in.secondary] + 1);
}

void write_interface(const MultiblockGrid& grid, const Interface& given, ByteWriter& file) {
    const Interface interface = forwards(given);
    const std::string what = fmt::format("interface '{}'", interface.name);
    const auto zone = static_cast<std::size_t>(interface.zone);
    const auto donor = static_cast<std::size_t>(interface.donor);
    const std::size_t own = face_number(interface.box, grid.zones[zone], grid.cell_dimension, what);
    const std::size_t other =
        face_number(interface.donor_box, grid.zones[donor], grid.cell_dimension, what);
    const auto across = static_cast<std::size_t>(
        std::abs(interface.orientation.axes[map_faces[own - 1].primary]) - 1);
    file.put(fmt::format("{}name {}\n", map_comment, on_one_line(interface.name)));
    if (interface.periodic) {
        const auto& [center, angle, translation] = *interface.periodic;
        file.put(fmt::format("{}periodic {} {} {} {} {} {} {} {} {}\n", map_comment, center.x,
                             center.y, center.z, angle.x, angle.y, angle.z, translation.x,
                             translation.y, translation.z));
    }
    file.put(fmt::format("{:<16}{}{}  {}\n", interface.periodic ? periodic_word : "ONE_TO_ONE",
                         range_text(zone, own, interface.box),
                         range_text(donor, other, interface.donor_box),
                         across == map_faces[other - 1].secondary ? "TRUE" : "FALSE"));
}

void write_patch(const MultiblockGrid& grid, const BoundaryPatch& patch, ByteWriter& file) {
    const auto zone = static_cast<std::size_t>(patch.zone);
    const std::size_t face = face_number(patch.box, grid.zones[zone], grid.cell_dimension,
                                         fmt::format("patch '{}'", patch.name));
    file.put(fmt::format("{}name {}\n", map_comment, on_one_line(patch.name)));
    if (!patch.type.empty()) file.put(fmt::format("{}type {}\n", map_comment, patch.type));
    file.put(fmt::format("{:<16}{}\n",
                         entry_type(grid.families[static_cast<std::size_t>(patch.family)].name),
                         range_text(zone, face, patch.box)));
}

void write_head(const MultiblockGrid& grid, ByteWriter& file) {
    const auto comment = [&file](const char* key, const std::string& value) {
        if (!value.empty()) {
            file.put(fmt::format("{}{} {}\n", map_comment, key, on_one_line(value)));
        }
    };
    file.put("# ===== Neutral Map File =====\n");
    comment("title", grid.title);
    comment("units", grid.units);
    comment("provenance", grid.provenance);
    for (const Family& family : grid.families) {
        comment("family", family.type + " " + family.name);
    }
    file.put("# Block#   IDIM   JDIM   KDIM\n");
    file.put(fmt::format("{:>8}\n", grid.zones.size()));
    for (std::size_t zone = 0; zone < grid.zones.size(); ++zone) {
        const Extent& extent = grid.zones[zone].points.extent();
        comment("zone", grid.zones[zone].name);
        file.put(
            fmt::format("{:>8} {:>6} {:>6} {:>6}\n", zone + 1, extent.ni, extent.nj, extent.nk));
    }
    file.put(
        "# Type             B1  F1     S1     E1     S2     E2    B2  F2     S1     E1     S2     "
        "E2  Swap\n");
}

}  // namespace

void write_neutral_map(const MultiblockGrid& grid, const std::filesystem::path& path) {
    ByteWriter file(path);
    write_head(grid, file);
    for (const Interface& interface : grid.interfaces) write_interface(grid, interface, file);
    for (const BoundaryPatch& patch : grid.patches) write_patch(grid, patch, file);
    file.close();
}

}  // namespace hexweave
