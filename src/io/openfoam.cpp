// SPDX-License-Identifier: Apache-2.0
#include "io/openfoam.h"

#include <fmt/format.h>

#include <iterator>

#include "io/byte_writer.h"

namespace hexweave {
namespace {

/// One file of a mesh, buffered in text.
class FoamFile {
public:
    FoamFile(const std::filesystem::path& path, const char* type, const char* object,
             const std::string& note = {})
        : file_(path) {
        add("FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class {};\n", type);
        if (!note.empty()) add("    note \"{}\";\n", note);
        add("    location \"constant/polyMesh\";\n    object {};\n}}\n\n", object);
    }

    template <class... Values>
    void add(fmt::format_string<Values...> format, Values&&... values) {
        constexpr std::size_t full = 1 << 16;
        fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
        if (text_.size() > full) flush();
    }

    void close() {
        flush();
        file_.close();
    }

private:
    void flush() {
        file_.put(text_.data(), text_.size());
        text_.clear();
    }

    ByteWriter file_;
    fmt::memory_buffer text_;
};

void write_labels(FoamFile& file, const std::vector<std::int32_t>& labels) {
    file.add("{}\n(\n", labels.size());
    for (const std::int32_t label : labels) file.add("{}\n", label);
    file.add(")\n");
    file.close();
}

void write_points(const PolyMesh& mesh, const std::filesystem::path& path) {
    FoamFile file(path, "vectorField", "points");
    file.add("{}\n(\n", mesh.points.size());
    for (const Vec3& p : mesh.points) file.add("({} {} {})\n", p.x, p.y, p.z);
    file.add(")\n");
    file.close();
}

void write_faces(const PolyMesh& mesh, const std::filesystem::path& path) {
    FoamFile file(path, "faceList", "faces");
    file.add("{}\n(\n", mesh.owner.size());
    for (std::size_t face = 0; face < mesh.owner.size(); ++face) {
        const std::size_t begin = mesh.face_begin[face];
        const std::size_t end = mesh.face_begin[face + 1];
        file.add("{}(", end - begin);
        for (std::size_t n = begin; n < end; ++n) {
            file.add("{}{}", mesh.face_points[n], n + 1 < end ? " " : ")\n");
        }
    }
    file.add(")\n");
    file.close();
}

std::string vector_text(const Vec3& v) {
    return fmt::format("({} {} {})", v.x + 0.0, v.y + 0.0, v.z + 0.0);  // no -0
}

std::string cyclic_text(const CyclicHalf& cyclic) {
    const std::string neighbour = fmt::format("        neighbourPatch {};\n", cyclic.neighbour);
    if (cyclic.axis == Vec3{}) {
        return neighbour +
               fmt::format("        transform translational;\n        separationVector {};\n",
                           vector_text(cyclic.separation));
    }
    return neighbour + fmt::format(
                           "        transform rotational;\n        rotationAxis {};\n"
                           "        rotationCentre {};\n",
                           vector_text(cyclic.axis), vector_text(cyclic.centre));
}

void write_boundary(const PolyMesh& mesh, const std::filesystem::path& path) {
    FoamFile file(path, "polyBoundaryMesh", "boundary");
    file.add("{}\n(\n", mesh.patches.size());
    for (const PolyPatch& patch : mesh.patches) {
        file.add(
            "    {}\n    {{\n        type {};\n        nFaces {};\n        startFace {};\n{}    "
            "}}\n",
            patch.name, patch.type, patch.count, patch.begin,
            patch.cyclic ? cyclic_text(*patch.cyclic) : "");
    }
    file.add(")\n");
    file.close();
}

}  // namespace

void write_poly_mesh(const PolyMesh& mesh, const std::array<std::filesystem::path, 5>& paths) {
    const std::string counts =
        fmt::format("nPoints:{}  nCells:{}  nFaces:{}  nInternalFaces:{}", mesh.points.size(),
                    mesh.cells, mesh.owner.size(), mesh.neighbour.size());
    write_points(mesh, paths[0]);
    write_faces(mesh, paths[1]);
    FoamFile owner(paths[2], "labelList", "owner", counts);
    write_labels(owner, mesh.owner);
    FoamFile neighbour(paths[3], "labelList", "neighbour", counts);
    write_labels(neighbour, mesh.neighbour);
    write_boundary(mesh, paths[4]);
}

}  // namespace hexweave
