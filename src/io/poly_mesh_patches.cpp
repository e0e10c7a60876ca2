// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "io/poly_mesh_parts.h"

namespace hexweave {
namespace {

/// How far the unit normals of a symmetry plane may differ from their mean: OpenFOAM stops beyond
/// 3e-8.
constexpr double flat_enough = 1e-8;

Vec3 area_vector(const PolyMesh& mesh, std::size_t face) {
    const auto point = [&](std::size_t n) {
        return mesh.points[static_cast<std::size_t>(mesh.face_points[n])];
    };
    const std::size_t begin = mesh.face_begin[face];
    Vec3 area{};
    for (std::size_t n = begin + 1; n + 1 < mesh.face_begin[face + 1]; ++n) {
        area += 0.5 * cross(point(n) - point(begin), point(n + 1) - point(begin));
    }
    return area;
}

bool is_plane(const PolyMesh& mesh, const PolyPatch& patch) {
    Vec3 mean{};
    std::vector<Vec3> normals;
    for (std::size_t face = patch.begin; face < patch.begin + patch.count; ++face) {
        const Vec3 area = area_vector(mesh, face);
        normals.push_back(area / norm(area));
        mean += normals.back();
    }
    mean = mean / static_cast<double>(patch.count);
    return std::all_of(normals.begin(), normals.end(),
                       [&](const Vec3& normal) { return distance(normal, mean) <= flat_enough; });
}

}  // namespace

bool has_types_of_patches(const MultiblockGrid& grid) {
    return std::any_of(grid.patches.begin(), grid.patches.end(),
                       [](const BoundaryPatch& patch) { return !patch.type.empty(); });
}

MultiblockGrid with_types_of_families(const MultiblockGrid& grid) {
    MultiblockGrid result = grid;
    for (BoundaryPatch& patch : result.patches) {
        if (patch.type.empty()) continue;
        const std::string& name = grid.families[static_cast<std::size_t>(patch.family)].name;
        const auto place = std::find_if(
            result.families.begin() + static_cast<std::ptrdiff_t>(grid.families.size()),
            result.families.end(),
            [&](const Family& f) { return f.name == name && f.type == patch.type; });
        const auto index = place - result.families.begin();
        if (place == result.families.end()) result.families.push_back({name, patch.type});
        patch.family = static_cast<int>(index);
        patch.type.clear();
    }
    return result;
}

std::string patch_name(const std::string& family, const std::vector<PolyPatch>& taken) {
    std::string word = family;
    std::replace_if(
        word.begin(), word.end(),
        [](unsigned char c) { return std::isalnum(c) == 0 && c != '_' && c != '-' && c != '.'; },
        '_');
    if (word.empty() ||
        (std::isalpha(static_cast<unsigned char>(word[0])) == 0 && word[0] != '_')) {
        word = "patch_" + word;
    }
    std::string name = word;
    const auto is_taken = [&] {
        return std::any_of(taken.begin(), taken.end(),
                           [&](const PolyPatch& patch) { return patch.name == name; });
    };
    for (int number = 2; is_taken(); ++number) name = fmt::format("{}_{}", word, number);
    return name;
}

std::string patch_type(const std::string& type, const PolyMesh& mesh, const PolyPatch& patch) {
    if (type == "empty") return type;
    if (type.starts_with("BCWall")) return "wall";
    if (type == "BCSymmetryPlane") return is_plane(mesh, patch) ? "symmetryPlane" : "symmetry";
    if (type == "BCSymmetryPolar") return "symmetry";
    if (type == "BCAxisymmetricWedge") return "wedge";
    return "patch";
}

}  // namespace hexweave
