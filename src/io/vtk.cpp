// SPDX-License-Identifier: Apache-2.0
#include "io/vtk.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <iterator>

#include "io/byte_writer.h"
#include "io/picture_text.h"

namespace hexweave {
namespace {

std::string head(const char* type) {
    return fmt::format(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n",
        type, std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian");
}

std::string attribute(const std::string& text) {
    return xml_escaped(printable(text));
}

/// A text as VTK keeps it in a file: the codes of its bytes, and a zero.
std::string field(const char* name, const std::string& text) {
    std::string codes;
    for (const char c : text) codes += fmt::format("{} ", static_cast<unsigned char>(c));
    return fmt::format(
        "      <Array type=\"String\" Name=\"{}\" NumberOfTuples=\"1\" format=\"ascii\">\n"
        "        {}0\n      </Array>\n",
        name, codes);
}

std::string field_data(const MultiblockGrid& grid, const VtkPiece& piece) {
    std::string text = field("Zone", grid.zones[static_cast<std::size_t>(piece.zone)].name);
    if (!grid.units.empty()) text += field("Units", grid.units);
    if (piece.patch >= 0) {
        const BoundaryPatch& patch = grid.patches[static_cast<std::size_t>(piece.patch)];
        const Family& family = grid.families[static_cast<std::size_t>(patch.family)];
        text +=
            field("Patch", patch.name) + field("Family", family.name) + field("Type", family.type);
    }
    return "    <FieldData>\n" + text + "    </FieldData>\n";
}

std::string extent_text(const IndexBox& box) {
    return fmt::format("0 {} 0 {} 0 {}", box.end[0] - box.begin[0], box.end[1] - box.begin[1],
                       box.end[2] - box.begin[2]);
}

void write_points(const PointField& points, const IndexBox& box, ByteWriter& file) {
    std::uint64_t bytes = 3 * sizeof(double);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        bytes *= static_cast<std::uint64_t>(box.end[axis] - box.begin[axis] + 1);
    }
    file.put(&bytes, sizeof bytes);
    std::vector<Vec3> row;
    for (int k = box.begin[2]; k <= box.end[2]; ++k) {
        for (int j = box.begin[1]; j <= box.end[1]; ++j) {
            row.clear();
            for (int i = box.begin[0]; i <= box.end[0]; ++i) row.push_back(points(i, j, k));
            file.put(row.data(), row.size() * sizeof(Vec3));
        }
    }
}

void write_data_set(const VtkPiece& piece, std::size_t index, const std::string& name,
                    const std::string& folder, ByteWriter& file) {
    file.put(fmt::format("      <DataSet index=\"{}\" name=\"{}\" file=\"{}\"/>\n", index,
                         attribute(name), attribute(folder + "/" + piece.file)));
}

}  // namespace

std::vector<VtkPiece> vtk_pieces(const MultiblockGrid& grid) {
    std::vector<VtkPiece> pieces;
    for (std::size_t zone = 0; zone < grid.zones.size(); ++zone) {
        const Extent& extent = grid.zones[zone].points.extent();
        pieces.push_back({fmt::format("zone{}.vts", zone + 1),
                          static_cast<int>(zone),
                          {{0, 0, 0}, {extent.ni - 1, extent.nj - 1, extent.nk - 1}}});
    }
    for (std::size_t patch = 0; patch < grid.patches.size(); ++patch) {
        pieces.push_back({fmt::format("patch{}.vts", patch + 1), grid.patches[patch].zone,
                          grid.patches[patch].box, static_cast<int>(patch)});
    }
    return pieces;
}

void write_vtk_piece(const MultiblockGrid& grid, const VtkPiece& piece,
                     const std::filesystem::path& path) {
    ByteWriter file(path);
    const std::string extent = extent_text(piece.box);
    file.put(head("StructuredGrid"));
    file.put(fmt::format("  <StructuredGrid WholeExtent=\"{}\">\n", extent));
    file.put(field_data(grid, piece));
    file.put(
        fmt::format("    <Piece Extent=\"{}\">\n"
                    "      <PointData/>\n      <CellData/>\n      <Points>\n"
                    "        <DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" "
                    "format=\"appended\" offset=\"0\"/>\n"
                    "      </Points>\n    </Piece>\n  </StructuredGrid>\n"
                    "  <AppendedData encoding=\"raw\">\n_",
                    extent));
    write_points(grid.zones[static_cast<std::size_t>(piece.zone)].points, piece.box, file);
    file.put("\n  </AppendedData>\n</VTKFile>\n");
    file.close();
}

void write_vtk_index(const MultiblockGrid& grid, const std::vector<VtkPiece>& pieces,
                     const std::string& folder, const std::filesystem::path& path) {
    ByteWriter file(path);
    file.put(head("vtkMultiBlockDataSet"));
    file.put("  <vtkMultiBlockDataSet>\n    <Block index=\"0\" name=\"zones\">\n");
    for (const VtkPiece& piece : pieces) {
        if (piece.patch >= 0) continue;
        const auto zone = static_cast<std::size_t>(piece.zone);
        write_data_set(piece, zone, grid.zones[zone].name, folder, file);
    }
    file.put("    </Block>\n    <Block index=\"1\" name=\"boundaries\">\n");
    for (std::size_t family = 0; family < grid.families.size(); ++family) {
        file.put(fmt::format("    <Block index=\"{}\" name=\"{}\">\n", family,
                             attribute(grid.families[family].name)));
        std::size_t index = 0;
        for (const VtkPiece& piece : pieces) {
            if (piece.patch < 0) continue;
            const BoundaryPatch& patch = grid.patches[static_cast<std::size_t>(piece.patch)];
            if (patch.family != static_cast<int>(family)) continue;
            write_data_set(piece, index++,
                           grid.zones[static_cast<std::size_t>(piece.zone)].name + "/" + patch.name,
                           folder, file);
        }
        file.put("    </Block>\n");
    }
    file.put("    </Block>\n  </vtkMultiBlockDataSet>\n</VTKFile>\n");
    file.close();
}

}  // namespace hexweave
