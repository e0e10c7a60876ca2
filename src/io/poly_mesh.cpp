// SPDX-License-Identifier: Apache-2.0
#include "io/poly_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/errors.h"
#include "core/interface_sides.h"
#include "core/length_unit.h"
#include "io/poly_mesh_parts.h"

namespace hexweave {
namespace {

/// The corners of side `side` of a cell, as offsets from its first node, in the order in which the
/// normal points out of a right-handed cell.
std::array<Node, 4> side_corners(Side side) {
    const auto a = static_cast<std::size_t>(axis_of(side));
    const std::size_t b = (a + 1) % 3;
    const std::size_t c = (a + 2) % 3;
    std::array<Node, 4> corners{};
    for (std::size_t n = 0; n < 4; ++n) {
        corners[n][a] = is_max(side) ? 1 : 0;
        const bool b_is_on = is_max(side) ? n == 1 || n == 2 : n == 2 || n == 3;
        const bool c_is_on = is_max(side) ? n == 2 || n == 3 : n == 1 || n == 2;
        corners[n][b] = b_is_on ? 1 : 0;
        corners[n][c] = c_is_on ? 1 : 0;
    }
    return corners;
}

/// Whether most of the zone's volume is negative.
bool is_left_handed(const PointField& points) {
    const Extent& extent = points.extent();
    double volume = 0;
    for (int k = 0; k + 1 < extent.nk; ++k) {
        for (int j = 0; j + 1 < extent.nj; ++j) {
            for (int i = 0; i + 1 < extent.ni; ++i) {
                const auto at = [&](int di, int dj, int dk) {
                    return points(i + di, j + dj, k + dk);
                };
                const Vec3 far = at(1, 1, 1) - at(0, 0, 0);
                const Vec3 u = at(1, 0, 0) - at(0, 1, 1) + far;
                const Vec3 v = at(0, 1, 0) - at(1, 0, 1) + far;
                const Vec3 w = at(0, 0, 1) - at(1, 1, 0) + far;
                volume += triple(u, v, w);
            }
        }
    }
    return volume < 0;
}

/// A boundary face until it is its turn.
struct BoundaryFace {
    int family = 0;
    std::int32_t cell = 0;
    std::array<std::int32_t, 4> points{};
};

class Builder {
public:
    explicit Builder(const MultiblockGrid& grid)
        : grid_(grid), numbering_(number_points(grid)), links_(link_sides(grid)) {
        for (const Zone& zone : grid.zones) reversed_.push_back(is_left_handed(zone.points));
    }

    PolyMesh build() {
        mesh_.points = numbering_.points;
        mesh_.cells = links_.cells;
        mesh_.face_begin.push_back(0);
        for (std::size_t zone = 0; zone < grid_.zones.size(); ++zone) add_zone(zone);
        add_boundary();
        for (const CyclicPair& pair : cyclic_pairs(grid_)) add_cyclic(pair);
        if (mesh_.owner.size() > std::numeric_limits<std::int32_t>::max()) {
            throw UsageError("an OpenFOAM mesh cannot hold this grid: it has too many faces");
        }
        return std::move(mesh_);
    }

private:
    /// What lies behind a side of a cell.
    struct Behind {
        std::int32_t neighbour = 0;
        Side side = Side::imin;
    };

    void add_zone(std::size_t zone) {
        const Extent& extent = grid_.zones[zone].points.extent();
        std::int32_t cell = links_.first_cell[zone];
        for (int k = 0; k + 1 < extent.nk; ++k) {
            for (int j = 0; j + 1 < extent.nj; ++j) {
                for (int i = 0; i + 1 < extent.ni; ++i) add_cell(zone, {i, j, k}, cell++);
            }
        }
    }

    void add_cell(std::size_t zone, const Node& n, std::int32_t cell) {
        const auto none = static_cast<std::int32_t>(grid_.families.size());
        std::array<Behind, 6> inner{};
        std::size_t count = 0;
        for (const Side side : all_sides) {
            const SideLink link = links_.behind(zone, n, side);
            if (link.is_boundary) {
                if (link.index > none) continue;
                boundary_.push_back({link.index, cell, points_at(zone, corners(zone, n, side))});
            } else if (link.index > cell) {
                std::size_t at = count++;
                for (; at > 0 && inner[at - 1].neighbour > link.index; --at) {
                    inner[at] = inner[at - 1];
                }
                inner[at] = {link.index, side};
            }
        }
        for (std::size_t f = 0; f < count; ++f) {
            if (add_face(points_at(zone, corners(zone, n, inner[f].side)), cell)) {
                mesh_.neighbour.push_back(inner[f].neighbour);
            }
        }
    }

    /// The nodes round a side of a cell, the normal out of the cell.
    std::array<Node, 4> corners(std::size_t zone, const Node& n, Side side) const {
        std::array<Node, 4> nodes = side_corners(side);
        for (Node& node : nodes) {
            for (std::size_t axis = 0; axis < 3; ++axis) node[axis] += n[axis];
        }
        if (reversed_[zone]) std::reverse(nodes.begin() + 1, nodes.end());
        return nodes;
    }

    std::array<std::int32_t, 4> points_at(std::size_t zone,
                                          const std::array<Node, 4>& nodes) const {
        std::array<std::int32_t, 4> points{};
        for (std::size_t c = 0; c < 4; ++c) {
            points[c] = numbering_.at(zone, grid_.zones[zone].points.extent(), nodes[c]);
        }
        return points;
    }

    /// Adds a face without points that follow themselves; false when no area is left.
    bool add_face(const std::array<std::int32_t, 4>& points, std::int32_t owner) {
        const std::size_t begin = mesh_.face_points.size();
        for (std::size_t c = 0; c < 4; ++c) {
            if (points[c] != points[(c + 1) % 4]) mesh_.face_points.push_back(points[c]);
        }
        if (mesh_.face_points.size() < begin + 3) {
            mesh_.face_points.resize(begin);
            return false;
        }
        mesh_.face_begin.push_back(mesh_.face_points.size());
        mesh_.owner.push_back(owner);
        return true;
    }

    void add_boundary() {
        std::stable_sort(boundary_.begin(), boundary_.end(),
                         [](const BoundaryFace& a, const BoundaryFace& b) {
                             return std::pair(a.family, a.cell) < std::pair(b.family, b.cell);
                         });
        for (std::size_t at = 0; at < boundary_.size();) {
            const int family = boundary_[at].family;
            PolyPatch patch;
            patch.begin = mesh_.owner.size();
            for (; at < boundary_.size() && boundary_[at].family == family; ++at) {
                add_face(boundary_[at].points, boundary_[at].cell);
            }
            patch.count = mesh_.owner.size() - patch.begin;
            if (patch.count == 0) continue;
            const bool has_family = family < static_cast<int>(grid_.families.size());
            const Family& source =
                has_family ? grid_.families[static_cast<std::size_t>(family)] : no_family;
            patch.name = patch_name(source.name, mesh_.patches);
            patch.type = patch_type(source.type, mesh_, patch);
            mesh_.patches.push_back(std::move(patch));
        }
    }

    /// The pair of patches: face by face the one half and its image, which begins with the image of
    /// the first point and goes round the other way.
    void add_cyclic(const CyclicPair& pair) {
        std::array<CyclicHalf, 2> halves = cyclic_halves(pair, metres_in(grid_.units));
        std::array<PolyPatch, 2> patches;
        for (std::size_t half = 0; half < 2; ++half) {
            PolyPatch& patch = patches[half];
            patch.begin = mesh_.owner.size();
            for (const std::size_t interface : pair.interfaces) {
                add_cyclic_faces(interface,
                                 (half == 1) != runs_back(pair, grid_.interfaces[interface]));
            }
            patch.count = mesh_.owner.size() - patch.begin;
            patch.type = "cyclic";
            patch.name = patch_name(pair.name + (half == 0 ? "_from" : "_to"), mesh_.patches);
        }
        if (patches[0].count == 0) return;
        for (std::size_t half = 0; half < 2; ++half) {
            halves[half].neighbour = patches[1 - half].name;
            patches[half].cyclic = halves[half];
            mesh_.patches.push_back(patches[half]);
        }
    }

    void add_cyclic_faces(std::size_t index, bool images) {
        const Interface interface = forwards(grid_.interfaces[index]);
        const auto zone = static_cast<std::size_t>(interface.zone);
        const auto donor = static_cast<std::size_t>(interface.donor);
        for (const CyclicFace& face : links_.cyclic[index]) {
            std::array<Node, 4> nodes = corners(zone, face.cell, face.side);
            if (!images) {
                add_face(points_at(zone, nodes), links_.cell(zone, face.cell));
                continue;
            }
            for (Node& node : nodes) node = donor_node(interface, node);
            std::reverse(nodes.begin() + 1, nodes.end());
            add_face(points_at(donor, nodes), links_.cell(donor, face.donor));
        }
    }

    inline static const Family no_family{"defaultFaces", "patch"};

    const MultiblockGrid& grid_;
    PointNumbering numbering_;
    SideLinks links_;
    PolyMesh mesh_;
    std::vector<BoundaryFace> boundary_;
    std::vector<bool> reversed_;  ///< by zone
};

}  // namespace

PolyMesh make_poly_mesh(const MultiblockGrid& grid) {
    if (has_types_of_patches(grid)) return make_poly_mesh(with_types_of_families(grid));
    if (grid.cell_dimension == 2) return Builder(one_cell_thick(grid)).build();
    return Builder(grid).build();
}

}  // namespace hexweave
