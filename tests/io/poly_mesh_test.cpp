// SPDX-License-Identifier: Apache-2.0
// Meshes of OpenFOAM against what OpenFOAM asks of them: closed cells, faces in upper-triangular
// order, positive volumes, one region, patches of the right size.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "core/errors.h"
#include "core/periodic_image.h"
#include "io/cgns_samples.h"
#include "io/openfoam.h"
#include "io/poly_mesh.h"
#include "io/scratch.h"

using namespace hexweave;
using Catch::Matchers::Contains;

namespace {

std::vector<std::int32_t> points_of(const PolyMesh& mesh, std::size_t face) {
    return {mesh.face_points.begin() + static_cast<std::ptrdiff_t>(mesh.face_begin[face]),
            mesh.face_points.begin() + static_cast<std::ptrdiff_t>(mesh.face_begin[face + 1])};
}

/// Faces of every cell, with +1 where their normal points out of it.
std::vector<std::vector<std::pair<std::size_t, int>>> faces_of_cells(const PolyMesh& mesh) {
    std::vector<std::vector<std::pair<std::size_t, int>>> cells(mesh.cells);
    for (std::size_t face = 0; face < mesh.owner.size(); ++face) {
        cells[static_cast<std::size_t>(mesh.owner[face])].emplace_back(face, 1);
        if (face >= mesh.neighbour.size()) continue;
        cells[static_cast<std::size_t>(mesh.neighbour[face])].emplace_back(face, -1);
    }
    return cells;
}

/// A cell is closed when each of its edges is walked once in either direction.
void check_closed(const PolyMesh& mesh) {
    for (const auto& faces : faces_of_cells(mesh)) {
        std::map<std::pair<std::int32_t, std::int32_t>, int> walked;
        for (const auto& [face, way] : faces) {
            const auto points = points_of(mesh, face);
            for (std::size_t n = 0; n < points.size(); ++n) {
                const std::int32_t a = points[n];
                const std::int32_t b = points[(n + 1) % points.size()];
                ++walked[way > 0 ? std::pair(a, b) : std::pair(b, a)];
            }
        }
        for (const auto& [edge, times] : walked) {
            CHECK(times == 1);
            CHECK(walked.count({edge.second, edge.first}) == 1);
        }
    }
}

/// The volumes of all cells, by the divergence theorem on triangles.
std::vector<double> volumes(const PolyMesh& mesh) {
    std::vector<double> all;
    for (const auto& faces : faces_of_cells(mesh)) {
        double volume = 0;
        for (const auto& [face, way] : faces) {
            const auto points = points_of(mesh, face);
            const auto at = [&](std::size_t n) {
                return mesh.points[static_cast<std::size_t>(points[n])];
            };
            for (std::size_t n = 1; n + 1 < points.size(); ++n) {
                volume += way * triple(at(0), at(n), at(n + 1)) / 6;
            }
        }
        all.push_back(volume);
    }
    return all;
}

void check_order(const PolyMesh& mesh) {
    for (std::size_t face = 0; face < mesh.neighbour.size(); ++face) {
        CHECK(mesh.owner[face] < mesh.neighbour[face]);
        if (face == 0) continue;
        const std::pair here(mesh.owner[face], mesh.neighbour[face]);
        CHECK(std::pair(mesh.owner[face - 1], mesh.neighbour[face - 1]) <= here);
    }
    std::size_t next = mesh.neighbour.size();
    for (const PolyPatch& patch : mesh.patches) {
        CHECK(patch.begin == next);
        next += patch.count;
        for (std::size_t face = patch.begin + 1; face < next && !patch.cyclic; ++face) {
            CHECK(mesh.owner[face - 1] <= mesh.owner[face]);
        }
    }
    CHECK(next == mesh.owner.size());
}

int regions(const PolyMesh& mesh) {
    std::vector<std::int32_t> region(mesh.cells);
    std::iota(region.begin(), region.end(), 0);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t face = 0; face < mesh.neighbour.size(); ++face) {
            auto& a = region[static_cast<std::size_t>(mesh.owner[face])];
            auto& b = region[static_cast<std::size_t>(mesh.neighbour[face])];
            if (a == b) continue;
            a = b = std::min(a, b);
            changed = true;
        }
    }
    return static_cast<int>(std::set(region.begin(), region.end()).size());
}

void check_sound(const PolyMesh& mesh) {
    check_closed(mesh);
    check_order(mesh);
    CHECK(regions(mesh) == 1);
    for (const double volume : volumes(mesh)) CHECK(volume > 0);
    const std::set<std::int32_t> used(mesh.face_points.begin(), mesh.face_points.end());
    CHECK(used.size() == mesh.points.size());
}

const PolyPatch& patch_of(const PolyMesh& mesh, const std::string& name) {
    for (const PolyPatch& patch : mesh.patches) {
        if (patch.name == name) return patch;
    }
    throw std::runtime_error("no patch " + name);
}

/// A box of 2 x 3 x 4 cells whose edge i = j = 0 is one line along k when `collapsed`: a wedge.
MultiblockGrid box(bool collapsed) {
    MultiblockGrid grid;
    grid.units = "m";
    PointField points({3, 4, 5});
    for (int k = 0; k < 5; ++k) {
        for (int j = 0; j < 4; ++j) {
            for (int i = 0; i < 3; ++i) {
                const double width = collapsed ? 0.5 * i : 1;
                points.set(i, j, k, {1.0 * i, width * j, 1.0 * k});
            }
        }
    }
    grid.zones.push_back({"box", points});
    return grid;
}

}  // namespace

TEST_CASE("Two blocks become one mesh, whichever way the second is turned") {
    for (const Orientation& rotation : rotations(3)) {
        const PolyMesh mesh = make_poly_mesh(joined_pair(3, 3, rotation));
        check_sound(mesh);
        CHECK(mesh.cells == 2 * 24);
        CHECK(mesh.points.size() == 2 * 60 - 20);
        CHECK(mesh.neighbour.size() == 2 * (12 + 2 * 2 * 4 + 2 * 3 * 3) + 12);
        REQUIRE(mesh.patches.size() == 2);
        CHECK(patch_of(mesh, "wall").type == "wall");
        CHECK(patch_of(mesh, "outer").type == "patch");
        CHECK(patch_of(mesh, "wall").count + patch_of(mesh, "outer").count == 2 * (12 + 16 + 12));
    }
}

TEST_CASE("A left-handed block has positive volumes and outward normals as well") {
    MultiblockGrid grid = joined_pair(3, 3, Orientation{});
    Zone& zone = grid.zones[1];
    const Extent extent = zone.points.extent();
    PointField mirrored(extent);
    for (int k = 0; k < extent.nk; ++k) {
        for (int j = 0; j < extent.nj; ++j) {
            for (int i = 0; i < extent.ni; ++i) {
                mirrored.set(i, extent.nj - 1 - j, k, zone.points(i, j, k));
            }
        }
    }
    zone.points = mirrored;
    grid.interfaces[0].orientation = Orientation{{1, -2, 3}};
    std::swap(grid.interfaces[0].donor_box.begin[1], grid.interfaces[0].donor_box.end[1]);
    check_sound(make_poly_mesh(grid));
}

TEST_CASE("A row of blocks keeps its volume") {
    const PolyMesh mesh = make_poly_mesh(row_of_zones(5, 4));
    check_sound(mesh);
    CHECK(mesh.points.size() == 16 * (5 * 3 + 1));
    const std::vector<double> all = volumes(make_poly_mesh(box(false)));
    CHECK(std::accumulate(all.begin(), all.end(), 0.0) == Approx(2 * 3 * 4));
}

TEST_CASE("A planar grid becomes one cell thick between empty sides") {
    for (const Orientation& rotation : rotations(2)) {
        const PolyMesh mesh = make_poly_mesh(joined_pair(2, 2, rotation));
        check_sound(mesh);
        CHECK(mesh.cells == 12);
        CHECK(mesh.points.size() == 2 * (24 - 4));
        CHECK(patch_of(mesh, "frontAndBack").type == "empty");
        CHECK(patch_of(mesh, "frontAndBack").count == 2 * 12);
        for (const Vec3& point : mesh.points) CHECK((point.z == 0 || point.z == 1));
    }
}

TEST_CASE("The two banks of a cut are joined, and lengths are metres") {
    const MultiblockGrid grid = c_grid();
    const PolyMesh mesh = make_poly_mesh(grid);
    CHECK(regions(mesh) == 1);
    check_order(mesh);
    // Three nodes of either bank are joined, and two neighbours at the nose are one point.
    CHECK(mesh.points.size() == 2 * (10 * 4 - 3 - 1));
    CHECK(mesh.points[0].x == 0.001 * grid.zones[0].points.x[0]);
    CHECK(patch_of(mesh, "foil").type == "wall");
    CHECK(patch_of(mesh, "overlap").type == "patch");
}

TEST_CASE("A collapsed side leaves prisms") {
    MultiblockGrid grid = box(true);
    grid.families = {{"axis", "BCDegenerateLine"}, {"side", "BCSymmetryPlane"}};
    const Extent extent = grid.zones[0].points.extent();
    grid.patches = {{"axis", 0, side_box(Side::imin, extent), 0},
                    {"low", 0, side_box(Side::jmin, extent), 1}};
    const PolyMesh mesh = make_poly_mesh(grid);
    check_sound(mesh);
    CHECK(mesh.points.size() == 60 - 15);
    REQUIRE(mesh.patches.size() == 2);
    CHECK(mesh.patches[0].name == "side");
    CHECK(mesh.patches[0].type == "symmetryPlane");
    CHECK(mesh.patches[1].name == "defaultFaces");
    grid.patches[1].box = side_box(Side::imax, extent);
    grid.zones[0].points.x(2, 1, 1) += 0.1;
    CHECK(make_poly_mesh(grid).patches[0].type == "symmetry");
}

namespace {

/// Points of the mesh that are not where the other half of their patch has them, as OpenFOAM pairs
/// faces: in order, first point to first point, round the other way.
int points_out_of_place(const PolyMesh& mesh, const PolyPatch& half, const PeriodicMap& map) {
    const PolyPatch& other = patch_of(mesh, half.cyclic->neighbour);
    REQUIRE(other.count == half.count);
    int wrong = 0;
    for (std::size_t n = 0; n < half.count; ++n) {
        const auto own = points_of(mesh, half.begin + n);
        const auto images = points_of(mesh, other.begin + n);
        REQUIRE(images.size() == own.size());
        for (std::size_t p = 0; p < own.size(); ++p) {
            const std::size_t opposite = (own.size() - p) % own.size();
            const Vec3 there = mesh.points[static_cast<std::size_t>(images[opposite])];
            const Vec3 here = mesh.points[static_cast<std::size_t>(own[p])];
            wrong += distance(image(map, here), there) > 1e-12 ? 1 : 0;
        }
    }
    return wrong;
}

/// A quarter ring of 2 x 3 x 4 cells, or half of one, about z, whose ends j are joined; from the
/// axis itself where the inner radius is 0.
MultiblockGrid sector(double angle, double inner) {
    MultiblockGrid grid = box(false);
    PointField& points = grid.zones[0].points;
    for (int k = 0; k < 5; ++k) {
        for (int j = 0; j < 4; ++j) {
            const PeriodicMap turn = periodic_map({{}, {0, 0, angle * j / 3}, {}});
            for (int i = 0; i < 3; ++i) points.set(i, j, k, image(turn, {inner + i, 0, 1.0 * k}));
        }
    }
    const Extent extent = points.extent();
    grid.interfaces = {{"blade-a",
                        0,
                        side_box(Side::jmin, extent),
                        0,
                        side_box(Side::jmax, extent),
                        {},
                        Periodicity{{}, {0, 0, angle}, {}}}};
    return grid;
}

}  // namespace

TEST_CASE("The two halves of a rotation are patches whose faces correspond") {
    for (const double inner : {1.0, 0.0}) {
        for (const double angle : {0.5 * std::numbers::pi, std::numbers::pi, -0.3}) {
            const MultiblockGrid grid = sector(angle, inner);
            const PolyMesh mesh = make_poly_mesh(grid);
            check_sound(mesh);
            const PolyPatch& from = patch_of(mesh, "blade_from");
            CHECK(from.type == "cyclic");
            CHECK(from.count == 8);
            CHECK(patch_of(mesh, "blade_to").cyclic->neighbour == "blade_from");
            CHECK(norm(from.cyclic->axis) == Approx(1));
            CHECK(std::abs(from.cyclic->axis.z) == Approx(1));
            CHECK(points_out_of_place(mesh, from, periodic_map(*grid.interfaces[0].periodic)) == 0);
        }
    }
}

TEST_CASE("Interfaces of one translation are one pair of patches, whichever way they are told") {
    MultiblockGrid grid = box(false);
    grid.units = "mm";
    const Extent extent = grid.zones[0].points.extent();
    const Vec3 way{2, 0, 0};
    IndexBox low = side_box(Side::imin, extent);
    IndexBox high = side_box(Side::imax, extent);
    low.end[1] = high.end[1] = 1;
    grid.interfaces.push_back({"pitch-low", 0, low, 0, high, {}, Periodicity{{}, {}, way}});
    low.begin[1] = high.begin[1] = 1;
    low.end[1] = high.end[1] = 3;
    grid.interfaces.push_back({"pitch-high", 0, high, 0, low, {}, Periodicity{{}, {}, -1 * way}});
    const PolyMesh mesh = make_poly_mesh(grid);
    check_sound(mesh);
    REQUIRE(mesh.patches.size() == 3);
    const PolyPatch& from = patch_of(mesh, "pitch_from");
    CHECK(from.count == 12);
    CHECK(from.cyclic->separation == Vec3{0.002, 0, 0});
    CHECK(patch_of(mesh, "pitch_to").cyclic->separation == Vec3{-0.002, 0, 0});
    CHECK(points_out_of_place(mesh, from, periodic_map({{}, {}, {0.002, 0, 0}})) == 0);
}

TEST_CASE("A translation in single precision is told as the nodes lie") {
    MultiblockGrid grid = box(false);
    const Extent extent = grid.zones[0].points.extent();
    grid.interfaces = {{"pitch",
                        0,
                        side_box(Side::imin, extent),
                        0,
                        side_box(Side::imax, extent),
                        {},
                        Periodicity{{}, {}, {2 + 1e-7, 0, 0}}}};
    CHECK(patch_of(make_poly_mesh(grid), "pitch_from").cyclic->separation == Vec3{2, 0, 0});
}

TEST_CASE("Names of patches are words, each of its own") {
    MultiblockGrid grid = box(false);
    const Extent extent = grid.zones[0].points.extent();
    grid.families = {{"a b", "BCWall"}, {"a/b", "BCInflow"}, {"1", "BCOutflow"}};
    grid.patches = {{"p", 0, side_box(Side::imin, extent), 0},
                    {"q", 0, side_box(Side::imax, extent), 1},
                    {"r", 0, side_box(Side::jmin, extent), 2}};
    const PolyMesh mesh = make_poly_mesh(grid);
    CHECK(mesh.patches[0].name == "a_b");
    CHECK(mesh.patches[1].name == "a_b_2");
    CHECK(mesh.patches[2].name == "patch_1");
}

TEST_CASE("A patch of OpenFOAM has one type, whatever types a family has") {
    MultiblockGrid grid = box(false);
    const Extent extent = grid.zones[0].points.extent();
    grid.families = {{"shell", "BCWall"}};
    grid.patches = {{"p", 0, side_box(Side::imin, extent), 0, "BCInflow"},
                    {"q", 0, side_box(Side::imax, extent), 0},
                    {"r", 0, side_box(Side::jmin, extent), 0, "BCInflow"}};
    const PolyMesh mesh = make_poly_mesh(grid);
    CHECK(mesh.patches[0].name == "shell");
    CHECK(mesh.patches[0].type == "wall");
    CHECK(mesh.patches[1].name == "shell_2");
    CHECK(mesh.patches[1].type == "patch");
    CHECK(mesh.patches[0].count == 12);
    CHECK(mesh.patches[1].count == 12 + 8);
}

TEST_CASE("What no mesh can hold is refused") {
    const auto refused = [](const MultiblockGrid& grid) {
        try {
            make_poly_mesh(grid);
        } catch (const UsageError& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    CHECK_THAT(refused(joined_pair(2, 3, Orientation{})), Contains("a surface in space"));
    MultiblockGrid apart = joined_pair(3, 3, Orientation{});
    apart.zones[1].points.y(0, 2, 2) += 0.5;
    CHECK_THAT(refused(apart), Contains("'seam' joins points that lie 0.5 apart"));
    MultiblockGrid twice = joined_pair(3, 3, Orientation{});
    twice.patches.push_back(twice.patches[0]);
    CHECK_THAT(refused(twice), Contains("covers a part of side"));
    MultiblockGrid screw = sector(1, 1);
    screw.interfaces[0].periodic->translation = {0, 0, 1e-9};
    CHECK_THAT(refused(screw), Contains("'blade-a' both turns and moves"));
    MultiblockGrid off = sector(1, 1);
    off.interfaces[0].periodic->angle.z = 0.9;
    CHECK_THAT(refused(off), Contains("'blade-a' joins points that lie 0.1 apart"));
    MultiblockGrid inside = joined_pair(3, 3, Orientation{});
    inside.patches[0].box = {{1, 0, 0}, {1, 3, 4}};
    CHECK_THAT(refused(inside), Contains("lies in no side"));
}

TEST_CASE("The five files hold the mesh as OpenFOAM writes it") {
    const Scratch scratch;
    std::array<std::filesystem::path, 5> paths;
    for (std::size_t n = 0; n < 5; ++n) paths[n] = scratch.path(poly_mesh_files[n]);
    MultiblockGrid grid = box(false);
    grid.families = {{"hull", "BCWallViscous"}};
    grid.patches = {{"p", 0, side_box(Side::kmin, grid.zones[0].points.extent()), 0}};
    write_poly_mesh(make_poly_mesh(grid), paths);
    CHECK_THAT(contents(paths[0]),
               Contains("class vectorField;") && Contains("\n60\n(\n(0 0 0)\n"));
    CHECK_THAT(contents(paths[1]), Contains("class faceList;") && Contains("\n98\n(\n4("));
    CHECK_THAT(contents(paths[2]), Contains("nPoints:60  nCells:24  nFaces:98  nInternalFaces:46"));
    CHECK_THAT(contents(paths[3]), Contains("\n46\n(\n1\n2\n6\n"));
    CHECK_THAT(contents(paths[4]), Contains("hull\n    {\n        type wall;\n        nFaces 6;\n"
                                            "        startFace 46;\n"));
    write_poly_mesh(make_poly_mesh(sector(1, 1)), paths);
    CHECK_THAT(contents(paths[4]),
               Contains("blade_to\n    {\n        type cyclic;\n        nFaces 8;\n") &&
                   Contains("        neighbourPatch blade_from;\n"
                            "        transform rotational;\n"
                            "        rotationAxis (0 0 1);\n"
                            "        rotationCentre (0 0 0);\n    }\n"));
}
