// SPDX-License-Identifier: Apache-2.0
#include "quality/turned_grids.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace hexweave::testing {
namespace {

std::size_t at(int n) {
    return static_cast<std::size_t>(n);
}

Extent turned(const Turn& turn, const Extent& extent) {
    std::array<int, 3> nodes{};
    for (int a = 0; a < 3; ++a) nodes[at(turn.axis[at(a)])] = extent[a];
    return {nodes[0], nodes[1], nodes[2]};
}

PointField turned(const Turn& turn, const PointField& points) {
    const Extent& e = points.extent();
    PointField result(turned(turn, e));
    for (int k = 0; k < e.nk; ++k)
        for (int j = 0; j < e.nj; ++j)
            for (int i = 0; i < e.ni; ++i) {
                const Node n = turned(turn, {i, j, k}, e);
                result.set(n[0], n[1], n[2], points(i, j, k));
            }
    return result;
}

Orientation turned(const Orientation& o, const Turn& own, const Turn& donor) {
    Orientation result;
    for (int a = 0; a < 3; ++a) {
        const int b = std::abs(o.axes[at(a)]) - 1;
        const bool back = ((o.axes[at(a)] < 0) != own.reversed[at(a)]) != donor.reversed[at(b)];
        const int along = donor.axis[at(b)] + 1;
        result.axes[at(own.axis[at(a)])] = back ? -along : along;
    }
    return result;
}

template <class PointAt>
Zone zone_of(const std::string& name, const Extent& extent, PointAt&& point_at) {
    Zone zone{name, PointField(extent)};
    for (int k = 0; k < extent.nk; ++k)
        for (int j = 0; j < extent.nj; ++j)
            for (int i = 0; i < extent.ni; ++i) zone.points.set(i, j, k, point_at(i, j, k));
    return zone;
}

Vec3 bent(double x, double y, double z) {
    return {x + 0.1 * std::sin(y + z), y + 0.1 * std::cos(x), z + 0.05 * x * y};
}

}  // namespace

std::vector<Turn> all_turns(int cell_dimension) {
    std::vector<Turn> turns;
    std::array<int, 3> axis{0, 1, 2};
    do {
        for (int code = 0; code < 8; ++code) {
            if (cell_dimension == 2 && (axis[2] != 2 || code >= 4)) continue;
            turns.push_back({axis, {(code & 1) != 0, (code & 2) != 0, (code & 4) != 0}});
        }
    } while (std::next_permutation(axis.begin(), axis.end()));
    return turns;
}

Node turned(const Turn& turn, const Node& node, const Extent& extent) {
    Node result{};
    for (int a = 0; a < 3; ++a) {
        const int n = node[at(a)];
        result[at(turn.axis[at(a)])] = turn.reversed[at(a)] ? extent[a] - 1 - n : n;
    }
    return result;
}

MultiblockGrid turned(const MultiblockGrid& grid, const std::vector<Turn>& turns) {
    MultiblockGrid result = grid;
    const auto move = [&](int zone, IndexBox box) {
        const Extent& extent = grid.zones[at(zone)].points.extent();
        return IndexBox{turned(turns[at(zone)], box.begin, extent),
                        turned(turns[at(zone)], box.end, extent)};
    };
    for (std::size_t z = 0; z < grid.zones.size(); ++z) {
        result.zones[z].points = turned(turns[z], grid.zones[z].points);
    }
    for (Interface& f : result.interfaces) {
        f.box = move(f.zone, f.box);
        f.donor_box = move(f.donor, f.donor_box);
        f.orientation = turned(f.orientation, turns[at(f.zone)], turns[at(f.donor)]);
    }
    for (BoundaryPatch& p : result.patches) p.box = move(p.zone, p.box);
    return result;
}

MultiblockGrid shuffled(const MultiblockGrid& grid) {
    MultiblockGrid result = grid;
    const int last = static_cast<int>(grid.zones.size()) - 1;
    std::reverse(result.zones.begin(), result.zones.end());
    for (Zone& zone : result.zones) zone.name = "other_" + zone.name;
    for (Interface& f : result.interfaces) {
        Orientation back;
        for (int a = 0; a < 3; ++a) {
            const int b = f.orientation.axes[at(a)];
            back.axes[at(std::abs(b) - 1)] = b < 0 ? -(a + 1) : a + 1;
        }
        const int zone = f.zone;
        f = {"seam", last - f.donor, f.donor_box, last - zone, f.box, back, f.periodic};
        if (f.periodic) {
            f.periodic->angle = -1 * f.periodic->angle;
            f.periodic->translation = -1 * f.periodic->translation;
        }
    }
    std::reverse(result.interfaces.begin(), result.interfaces.end());
    std::reverse(result.patches.begin(), result.patches.end());
    for (BoundaryPatch& p : result.patches) p.zone = last - p.zone;
    return result;
}

MultiblockGrid three_blocks() {
    MultiblockGrid grid;
    grid.units = "m";
    // The left one, the right one, and one upon both whose i runs down and whose j runs back.
    grid.zones.push_back(
        zone_of("left", {4, 5, 6}, [](int i, int j, int k) { return bent(i, j, 0.5 * k); }));
    grid.zones.push_back(
        zone_of("right", {7, 5, 6}, [](int i, int j, int k) { return bent(3 + i, j, 0.5 * k); }));
    grid.zones.push_back(zone_of("top", {3, 10, 5}, [](int i, int j, int k) {
        return bent(9 - j, k, 2.5 + 0.5 * (2 - i));
    }));
    grid.interfaces = {{"a", 0, {{3, 0, 0}, {3, 4, 5}}, 1, {{0, 0, 0}, {0, 4, 5}}, {{1, 2, 3}}},
                       {"b", 0, {{0, 0, 5}, {3, 4, 5}}, 2, {{2, 9, 0}, {2, 6, 4}}, {{-2, 3, -1}}},
                       {"c", 1, {{0, 0, 5}, {6, 4, 5}}, 2, {{2, 6, 0}, {2, 0, 4}}, {{-2, 3, -1}}},
                       {"d",
                        0,
                        {{0, 0, 0}, {3, 0, 5}},
                        0,
                        {{0, 4, 0}, {3, 4, 5}},
                        {{1, 2, 3}},
                        Periodicity{{}, {}, {0, 4, 0}}}};
    grid.families = {{"floor", "BCWallViscous"}, {"ends", "BCInflow"}, {"lid", "BCFarfield"}};
    grid.patches = {{"f", 0, side_box(Side::kmin, {4, 5, 6}), 0},
                    {"g", 1, side_box(Side::kmin, {7, 5, 6}), 0},
                    {"h", 0, side_box(Side::imin, {4, 5, 6}), 1},
                    {"i", 1, {{6, 0, 0}, {6, 2, 5}}, 1},
                    {"j", 1, {{6, 2, 0}, {6, 4, 5}}, 2},
                    {"k", 2, side_box(Side::imin, {3, 10, 5}), 2}};
    return grid;
}

MultiblockGrid ring() {
    MultiblockGrid grid;
    grid.cell_dimension = 2;
    grid.physical_dimension = 2;
    grid.zones.push_back(zone_of("ring", {41, 7, 1}, [](int i, int j, int) {
        const double angle = i == 40 ? 0 : i * std::acos(-1.0) / 20;
        return Vec3{(1 + j) * 2 * std::cos(angle), (1 + j) * std::sin(angle), 0};
    }));
    grid.interfaces = {
        {"cut", 0, {{0, 0, 0}, {0, 6, 0}}, 0, {{40, 0, 0}, {40, 6, 0}}, {{1, 2, 3}}}};
    grid.families = {{"body", "BCWall"}};
    grid.patches = {{"body", 0, side_box(Side::jmin, {41, 7, 1}), 0}};
    return grid;
}

}  // namespace hexweave::testing
