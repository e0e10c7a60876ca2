// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/errors.h"
#include "core/interface_sides.h"
#include "core/length_unit.h"
#include "core/periodic_image.h"
#include "io/poly_mesh_parts.h"

namespace hexweave {
namespace {

/// How far joined points may lie apart, as a fraction of the shortest edge at one of them.
constexpr double widest_gap = 0.01;

[[noreturn]] void cannot_hold(const std::string& fact) {
    throw UsageError(fmt::format("an OpenFOAM mesh cannot hold this grid: {}", fact));
}

/// Sets of nodes that are one point, each known by its first node.
class NodeSets {
public:
    explicit NodeSets(std::size_t nodes) : parent_(nodes) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    std::int32_t find(std::int32_t node) {
        while (parent(node) != node) {
            parent(node) = parent(parent(node));
            node = parent(node);
        }
        return node;
    }

    void unite(std::int32_t a, std::int32_t b) {
        a = find(a);
        b = find(b);
        parent(std::max(a, b)) = std::min(a, b);
    }

private:
    std::int32_t& parent(std::int32_t node) { return parent_[static_cast<std::size_t>(node)]; }

    std::vector<std::int32_t> parent_;
};

/// The shortest edge at a node that has a length.
double shortest_edge(const PointField& points, const Node& n) {
    const Extent& extent = points.extent();
    const Vec3 here = points(n[0], n[1], n[2]);
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int step : {-1, 1}) {
            Node other = n;
            other[axis] += step;
            if (other[axis] < 0 || other[axis] >= extent[static_cast<int>(axis)]) continue;
            const double length = distance(here, points(other[0], other[1], other[2]));
            if (length > 0) shortest = std::min(shortest, length);
        }
    }
    return shortest;
}

class Joiner {
public:
    Joiner(const MultiblockGrid& grid, const std::vector<std::size_t>& first_node, NodeSets& sets)
        : grid_(grid), first_node_(first_node), sets_(sets) {}

    void join(const Interface& interface) {
        const PointField& own = points(interface.zone);
        const PointField& other = points(interface.donor);
        const PeriodicMap map = periodic_map(interface.periodic.value_or(Periodicity{}));
        for_each_node(interface.box, [&](const Node& n) {
            const Node m = donor_node(interface, n);
            const Vec3 here = image(map, own(n[0], n[1], n[2]));
            const double gap = distance(here, other(m[0], m[1], m[2]));
            if (gap > 0 && !(gap <= widest_gap * shortest_edge(own, n))) {
                cannot_hold(fmt::format("interface '{}' joins points that lie {:.3g} apart",
                                        interface.name, gap));
            }
            if (interface.periodic) return;
            sets_.unite(number(interface.zone, n), number(interface.donor, m));
        });
    }

    /// Unites neighbouring nodes of the sides of a zone that coincide.
    void collapse(int zone) {
        const Extent& extent = points(zone).extent();
        for (const Side side : all_sides) {
            const IndexBox box = side_box(side, extent);
            for_each_node(box, [&](const Node& n) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    Node next = n;
                    if (++next[axis] > box.end[axis]) continue;
                    if (points(zone)(n[0], n[1], n[2]) == points(zone)(next[0], next[1], next[2])) {
                        sets_.unite(number(zone, n), number(zone, next));
                    }
                }
            });
        }
    }

private:
    template <class Task>
    static void for_each_node(const IndexBox& box, Task&& task) {
        for (int k = box.begin[2]; k <= box.end[2]; ++k) {
            for (int j = box.begin[1]; j <= box.end[1]; ++j) {
                for (int i = box.begin[0]; i <= box.end[0]; ++i) task(Node{i, j, k});
            }
        }
    }

    const PointField& points(int zone) const {
        return grid_.zones[static_cast<std::size_t>(zone)].points;
    }

    std::int32_t number(int zone, const Node& n) const {
        return static_cast<std::int32_t>(first_node_[static_cast<std::size_t>(zone)] +
                                         points(zone).extent().offset(n[0], n[1], n[2]));
    }

    const MultiblockGrid& grid_;
    const std::vector<std::size_t>& first_node_;
    NodeSets& sets_;
};

}  // namespace

MultiblockGrid one_cell_thick(const MultiblockGrid& planar) {
    MultiblockGrid grid = planar;
    grid.cell_dimension = 3;
    grid.physical_dimension = 3;
    const auto family = static_cast<int>(grid.families.size());
    const auto thicken = [](IndexBox box) {
        box.end[2] = 1;
        return box;
    };
    const double level = planar.zones.empty() ? 0 : planar.zones[0].points.z[0];
    for (std::size_t zone = 0; zone < grid.zones.size(); ++zone) {
        const PointField& flat = planar.zones[zone].points;
        const Extent& extent = flat.extent();
        PointField& thick = grid.zones[zone].points;
        thick = PointField({extent.ni, extent.nj, 2});
        for (std::size_t n = 0; n < extent.nodes(); ++n) {
            const Vec3 point = flat[n];
            if (!(point.z == level)) {
                cannot_hold("it is a surface in space; a planar grid has one z everywhere");
            }
            thick.set(n, point);
            thick.set(extent.nodes() + n, {point.x, point.y, point.z + 1});
        }
        for (const Side side : {Side::kmin, Side::kmax}) {
            grid.patches.push_back(
                {"frontAndBack", static_cast<int>(zone), side_box(side, thick.extent()), family});
        }
    }
    for (std::size_t n = 0; n < planar.patches.size(); ++n) {
        grid.patches[n].box = thicken(planar.patches[n].box);
    }
    for (Interface& interface : grid.interfaces) {
        interface = forwards(interface);
        interface.box = thicken(interface.box);
        interface.donor_box = thicken(interface.donor_box);
    }
    grid.families.push_back({"frontAndBack", "empty"});
    return grid;
}

PointNumbering number_points(const MultiblockGrid& grid) {
    PointNumbering numbering;
    std::size_t nodes = 0;
    for (const Zone& zone : grid.zones) {
        numbering.first_node.push_back(nodes);
        nodes += zone.points.extent().nodes();
    }
    if (nodes > std::numeric_limits<std::int32_t>::max()) {
        cannot_hold("it has more than 2147483647 nodes");
    }
    NodeSets sets(nodes);
    Joiner joiner(grid, numbering.first_node, sets);
    for (const Interface& interface : grid.interfaces) joiner.join(forwards(interface));
    for (std::size_t zone = 0; zone < grid.zones.size(); ++zone) {
        joiner.collapse(static_cast<int>(zone));
    }
    const double scale = metres_in(grid.units);
    numbering.point_of_node.resize(nodes);
    std::int32_t node = 0;
    for (const Zone& zone : grid.zones) {
        for (std::size_t n = 0; n < zone.points.extent().nodes(); ++n, ++node) {
            const std::int32_t first = sets.find(node);
            auto& point = numbering.point_of_node[static_cast<std::size_t>(node)];
            if (first != node) {
                point = numbering.point_of_node[static_cast<std::size_t>(first)];
                continue;
            }
            point = static_cast<std::int32_t>(numbering.points.size());
            numbering.points.push_back(scale * zone.points[n]);
        }
    }
    return numbering;
}

}  // namespace hexweave
