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
std::string field(const VtkText& text) {
    std::string codes;
    for (const char c : text.text) codes += fmt::format("{} ", static_cast<unsigned char>(c));
    return fmt::format(
        "      <Array type=\"String\" Name=\"{}\" NumberOfTuples=\"1\" format=\"ascii\">\n"
        "        {}0\n      </Array>\n",
        text.name, codes);
}

std::string field_data(const std::vector<VtkText>& texts) {
    std::string all = "    <FieldData>\n";
    for (const VtkText& text : texts) {
        if (!text.text.empty()) all += field(text);
    }
    return all + "    </FieldData>\n";
}

std::vector<VtkText> texts_of(const MultiblockGrid& grid, const VtkPiece& piece) {
    std::vector<VtkText> texts{{"Zone", grid.zones[static_cast<std::size_t>(piece.zone)].name},
                               {"Units", grid.units}};
    if (piece.patch >= 0) {
        const BoundaryPatch& patch = grid.patches[static_cast<std::size_t>(piece.patch)];
        const Family& family = grid.families[static_cast<std::size_t>(patch.family)];
        texts.push_back({"Patch", patch.name});
        texts.push_back({"Family", family.name});
        texts.push_back({"Type", type_of(patch, grid.families)});
    }
    return texts;
}

std::string extent_text(const IndexBox& box) {
    return fmt::format("0 {} 0 {} 0 {}", box.end[0] - box.begin[0], box.end[1] - box.begin[1],
                       box.end[2] - box.begin[2]);
}

std::uint64_t bytes_of_points(const IndexBox& box) {
    std::uint64_t bytes = 3 * sizeof(double);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        bytes *= static_cast<std::uint64_t>(box.end[axis] - box.begin[axis] + 1);
    }
    return bytes;
}

void write_points(const PointField& points, const IndexBox& box, ByteWriter& file) {
    const std::uint64_t bytes = bytes_of_points(box);
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

void write_values(const std::vector<double>& values, ByteWriter& file) {
    const std::uint64_t bytes = values.size() * sizeof(double);
    file.put(&bytes, sizeof bytes);
    file.put(values.data(), bytes);
}

/// The part of a grid's points in a box, as a file of its own. Points come first in the appended
/// data, then the arrays; each begins with its number of bytes.
void write_box(const PointField& points, const IndexBox& box, const std::vector<VtkText>& texts,
               const std::vector<VtkCellArray>& cells, const std::filesystem::path& path) {
    ByteWriter file(path);
    const std::string extent = extent_text(box);
    file.put(head("StructuredGrid"));
    file.put(
        fmt::format("  <StructuredGrid WholeExtent=\"{}\">\n{}    <Piece Extent=\"{}\">\n"
                    "      <PointData/>\n      <CellData>\n",
                    extent, field_data(texts), extent));
    std::uint64_t offset = sizeof(std::uint64_t) + bytes_of_points(box);
    for (const VtkCellArray& array : cells) {
        file.put(
            fmt::format("        <DataArray type=\"Float64\" Name=\"{}\" format=\"appended\" "
                        "offset=\"{}\"/>\n",
                        attribute(array.name), offset));
        offset += sizeof(std::uint64_t) + array.values.size() * sizeof(double);
    }
    file.put(
        "      </CellData>\n      <Points>\n"
        "        <DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" "
        "format=\"appended\" offset=\"0\"/>\n"
        "      </Points>\n    </Piece>\n  </StructuredGrid>\n"
        "  <AppendedData encoding=\"raw\">\n_");
    write_points(points, box, file);
    for (const VtkCellArray& array : cells) write_values(array.values, file);
    file.put("\n  </AppendedData>\n</VTKFile>\n");
    file.close();
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

void write_vtk_grid(const PointField& points, const std::vector<VtkText>& texts,
                    const std::vector<VtkCellArray>& cells, const std::filesystem::path& path) {
    const Extent& e = points.extent();
    write_box(points, {{0, 0, 0}, {e.ni - 1, e.nj - 1, e.nk - 1}}, texts, cells, path);
}

void write_vtk_piece(const MultiblockGrid& grid, const VtkPiece& piece,
                     const std::filesystem::path& path) {
    write_box(grid.zones[static_cast<std::size_t>(piece.zone)].points, piece.box,
              texts_of(grid, piece), {}, path);
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
