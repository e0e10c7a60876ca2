// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <limits>

#include "core/errors.h"
#include "core/interface_sides.h"
#include "io/poly_mesh_parts.h"

namespace hexweave {
namespace {

constexpr std::int32_t nothing = -1;

[[noreturn]] void cannot_hold(const std::string& fact) {
    throw UsageError(fmt::format("an OpenFOAM mesh cannot hold this grid: {}", fact));
}

/// The side of the zone that a rectangle of nodes lies in.
Side side_of(const IndexBox& box, const Zone& zone, const std::string& what) {
    for (const Side side : all_sides) {
        const auto axis = static_cast<std::size_t>(axis_of(side));
        const int place = is_max(side) ? zone.points.extent()[axis_of(side)] - 1 : 0;
        if (box.begin[axis] == place && box.end[axis] == place) return side;
    }
    cannot_hold(fmt::format("{} lies in no side of zone '{}'", what, zone.name));
}

Extent cells_of(const Extent& nodes) {
    return {nodes.ni - 1, nodes.nj - 1, nodes.nk - 1};
}

/// Position of a cell among those of a side.
std::size_t place_in_side(const Extent& cells, Side side, const Node& n) {
    const std::array<int, 2> axes = tangential_axes(side);
    const auto first = static_cast<std::size_t>(axes[0]);
    const auto second = static_cast<std::size_t>(axes[1]);
    return static_cast<std::size_t>(n[first]) +
           static_cast<std::size_t>(cells[axes[0]]) * static_cast<std::size_t>(n[second]);
}

/// The cell whose side `side` lies between the nodes a and b (opposite corners).
Node cell_between(const Node& a, const Node& b, Side side) {
    Node cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) cell[axis] = std::min(a[axis], b[axis]);
    if (is_max(side)) --cell[static_cast<std::size_t>(axis_of(side))];
    return cell;
}

class Linker {
public:
    explicit Linker(const MultiblockGrid& grid) : grid_(grid) {
        for (const Zone& zone : grid.zones) {
            const Extent cells = cells_of(zone.points.extent());
            if (links_.cells + cells.nodes() > std::numeric_limits<std::int32_t>::max()) {
                cannot_hold("it has more than 2147483647 cells");
            }
            links_.first_cell.push_back(static_cast<std::int32_t>(links_.cells));
            links_.cells += cells.nodes();
            links_.extents.push_back(cells);
            auto& sides = links_.sides.emplace_back();
            for (const Side side : all_sides) {
                const std::array<int, 2> axes = tangential_axes(side);
                sides[static_cast<std::size_t>(side)].assign(
                    static_cast<std::size_t>(cells[axes[0]]) *
                        static_cast<std::size_t>(cells[axes[1]]),
                    {true, nothing});
            }
        }
    }

    SideLinks link() {
        links_.cyclic.resize(grid_.interfaces.size());
        for (std::size_t n = 0; n < grid_.interfaces.size(); ++n) join(n);
        for (const BoundaryPatch& patch : grid_.patches) bound(patch);
        const auto no_family = static_cast<std::int32_t>(grid_.families.size());
        for (auto& sides : links_.sides) {
            for (auto& side : sides) {
                for (SideLink& link : side) {
                    if (link.index == nothing) link.index = no_family;
                }
            }
        }
        return std::move(links_);
    }

private:
    void set(int zone, Side side, const Node& cell, SideLink value, const std::string& what) {
        const auto z = static_cast<std::size_t>(zone);
        SideLink& link = links_.sides[z][static_cast<std::size_t>(side)]
                                     [place_in_side(links_.extents[z], side, cell)];
        if (link.index != nothing) {
            cannot_hold(
                fmt::format("{} covers a part of side {} of zone '{}' that something else "
                            "covers as well",
                            what, side_name(side), grid_.zones[z].name));
        }
        link = value;
    }

    /// Calls task(a, b) with opposite corners of each face of a side in the box.
    template <class Task>
    static void for_each_face(const IndexBox& box, Side side, Task&& task) {
        const std::array<int, 2> axes = tangential_axes(side);
        const auto u = static_cast<std::size_t>(axes[0]);
        const auto v = static_cast<std::size_t>(axes[1]);
        for (int q = box.begin[v]; q < box.end[v]; ++q) {
            for (int p = box.begin[u]; p < box.end[u]; ++p) {
                Node a = box.begin;
                a[u] = p;
                a[v] = q;
                Node b = a;
                ++b[u];
                ++b[v];
                task(a, b);
            }
        }
    }

    void join(std::size_t index) {
        const Interface interface = forwards(grid_.interfaces[index]);
        const std::string what = fmt::format("interface '{}'", interface.name);
        const auto zone = static_cast<std::size_t>(interface.zone);
        const auto donor = static_cast<std::size_t>(interface.donor);
        const Side side = side_of(interface.box, grid_.zones[zone], what);
        const Side other_side = side_of(interface.donor_box, grid_.zones[donor], what);
        for_each_face(interface.box, side, [&](const Node& a, const Node& b) {
            const Node own = cell_between(a, b, side);
            const Node other =
                cell_between(donor_node(interface, a), donor_node(interface, b), other_side);
            if (interface.periodic) {
                const auto periodic = static_cast<std::int32_t>(grid_.families.size()) + 1;
                set(interface.zone, side, own, {true, periodic}, what);
                set(interface.donor, other_side, other, {true, periodic}, what);
                links_.cyclic[index].push_back({own, side, other});
                return;
            }
            if (zone == donor && own == other) {
                cannot_hold(fmt::format("{} joins a cell to itself", what));
            }
            set(interface.zone, side, own, {false, links_.cell(donor, other)}, what);
            set(interface.donor, other_side, other, {false, links_.cell(zone, own)}, what);
        });
    }

    void bound(const BoundaryPatch& patch) {
        const std::string what = fmt::format("patch '{}'", patch.name);
        const auto zone = static_cast<std::size_t>(patch.zone);
        const Side side = side_of(patch.box, grid_.zones[zone], what);
        for_each_face(patch.box, side, [&](const Node& a, const Node& b) {
            set(patch.zone, side, cell_between(a, b, side), {true, patch.family}, what);
        });
    }

    const MultiblockGrid& grid_;
    SideLinks links_;
};

}  // namespace

std::int32_t SideLinks::cell(std::size_t zone, const Node& n) const {
    return first_cell[zone] + static_cast<std::int32_t>(extents[zone].offset(n[0], n[1], n[2]));
}

SideLink SideLinks::behind(std::size_t zone, const Node& n, Side side) const {
    const auto axis = static_cast<std::size_t>(axis_of(side));
    Node next = n;
    next[axis] += is_max(side) ? 1 : -1;
    if (next[axis] >= 0 && next[axis] < extents[zone][axis_of(side)]) {
        return {false, cell(zone, next)};
    }
    return sides[zone][static_cast<std::size_t>(side)][place_in_side(extents[zone], side, n)];
}

SideLinks link_sides(const MultiblockGrid& grid) {
    return Linker(grid).link();
}

}  // namespace hexweave
