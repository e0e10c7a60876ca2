// SPDX-License-Identifier: Apache-2.0
#include "io/cgns_samples.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace hexweave {
namespace {

/// A smooth one-to-one map of lattice points into space, with no round numbers in it.
Vec3 place(double i, double j, double k, int physical_dimension) {
    if (physical_dimension == 2) return {i + 0.1 * std::sin(j), j + 0.1 * std::cos(i), 0};
    return {i + 0.1 * std::sin(j), j + 0.1 * std::cos(k + i), k + 0.1 * std::sin(i * j)};
}

template <class PointAt>
PointField fill(const Extent& extent, PointAt&& point_at) {
    PointField points(extent);
    for (int k = 0; k < extent.nk; ++k) {
        for (int j = 0; j < extent.nj; ++j) {
            for (int i = 0; i < extent.ni; ++i) points.set(i, j, k, point_at(Node{i, j, k}));
        }
    }
    return points;
}

MultiblockGrid empty_grid(int cell_dimension, int physical_dimension) {
    MultiblockGrid grid{"a sample",
                        "m",
                        cell_dimension,
                        physical_dimension,
                        {},
                        {},
                        {},
                        {},
                        "hexweave 0.0.0, config 0123456789abcdef"};
    return grid;
}

/// A patch on every side of `zone` except one.
void bound(MultiblockGrid& grid, int zone, Side except) {
    const Extent& extent = grid.zones[static_cast<std::size_t>(zone)].points.extent();
    for (const Side side :
         {Side::imax, Side::imin, Side::jmax, Side::jmin, Side::kmax, Side::kmin}) {
        if (side == except || axis_of(side) >= grid.cell_dimension) continue;
        grid.patches.push_back(
            {std::string(side_name(side)), zone, side_box(side, extent), is_max(side) ? 0 : 1});
    }
}

}  // namespace

std::vector<Orientation> rotations(int cell_dimension) {
    std::vector<Orientation> found;
    for (int code = 0; code < 7 * 7 * 7; ++code) {
        const Orientation o{{code % 7 - 3, code / 7 % 7 - 3, code / 49 - 3}};
        bool seen[4] = {};
        for (const int axis : o.axes) seen[std::abs(axis)] = true;
        const bool permutes = !seen[0] && seen[1] && seen[2] && seen[3];
        if (!permutes || (cell_dimension == 2 && o.axes[2] != 3)) continue;
        if (determinant(o) == 1) found.push_back(o);
    }
    return found;
}

MultiblockGrid joined_pair(int cell_dimension, int physical_dimension,
                           const Orientation& b_to_lattice) {
    MultiblockGrid grid = empty_grid(cell_dimension, physical_dimension);
    const Extent lattice{3, 4, cell_dimension == 3 ? 5 : 1};
    const Extent b = own_extent(b_to_lattice, lattice);
    const auto at = [&](const Node& n, int shift) {
        return place(n[0] + shift, n[1], n[2], physical_dimension);
    };
    grid.zones.push_back({"a", fill(lattice, [&](const Node& n) { return at(n, 0); })});
    grid.zones.push_back({"b", fill(b, [&](const Node& n) {
                              return at(map_node(b_to_lattice, n, lattice), lattice.ni - 1);
                          })});
    grid.families = {{"outer", "BCFarfield"}, {"wall", "BCWallViscous"}};
    const Orientation to_b = inverse(b_to_lattice);
    const IndexBox seam = side_box(Side::imin, lattice);
    const IndexBox donor{map_node(to_b, seam.begin, b), map_node(to_b, seam.end, b)};
    grid.interfaces.push_back({"seam", 0, side_box(Side::imax, lattice), 1, donor, to_b});
    bound(grid, 0, Side::imax);
    const int across = to_b.axes[0];
    bound(grid, 1, static_cast<Side>(2 * (std::abs(across) - 1) + (across > 0 ? 0 : 1)));
    return grid;
}

MultiblockGrid c_grid() {
    MultiblockGrid grid = empty_grid(2, 2);
    grid.units = std::string("mm");
    const int wake = 3;
    const int around = 5;
    const Extent extent{2 * wake + around - 1, 4, 1};
    const int last = extent.ni - 1;
    grid.zones.push_back(
        {"c", fill(extent, [&](const Node& n) {
             const double turn = 3.14159 * std::abs(n[0] - 0.5 * last) / last;
             const double side = n[0] < last - n[0] ? -1 : 1;
             return Vec3{-std::cos(turn) * (1 + n[1]), n[1] * side * std::sin(turn), 0};
         })});
    grid.interfaces.push_back({"wake",
                               0,
                               {{0, 0, 0}, {wake - 1, 0, 0}},
                               0,
                               {{last, 0, 0}, {last - wake + 1, 0, 0}},
                               Orientation{{-1, -2, 3}}});
    grid.families = {{"far", "BCFarfield"},
                     {"foil", "BCWall"},
                     {"overlap", "UserDefined:BCOverset"},
                     {"unassigned", "UserDefined"}};
    grid.patches = {{"foil", 0, {{wake - 1, 0, 0}, {last - wake + 1, 0, 0}}, 1},
                    {"out", 0, side_box(Side::jmax, extent), 0},
                    {"out_low", 0, side_box(Side::imin, extent), 2},
                    {"out_up", 0, side_box(Side::imax, extent), 3}};
    return grid;
}

MultiblockGrid row_of_zones(int count, int nodes) {
    MultiblockGrid grid = empty_grid(3, 3);
    grid.families = {{"outer", "BCFarfield"}, {"wall", "BCWallViscous"}};
    const Extent extent{nodes, nodes, nodes};
    for (int zone = 0; zone < count; ++zone) {
        grid.zones.push_back({fmt::format("block{:06}", zone), fill(extent, [&](const Node& n) {
                                  return place(n[0] + zone * (nodes - 1), n[1], n[2], 3);
                              })});
        bound(grid, zone, Side::imax);
        if (zone == 0) continue;
        grid.patches.erase(grid.patches.end() - 5);
        grid.interfaces.push_back({fmt::format("seam{:06}", zone), zone - 1,
                                   side_box(Side::imax, extent), zone, side_box(Side::imin, extent),
                                   Orientation{}});
    }
    return grid;
}

}  // namespace hexweave
