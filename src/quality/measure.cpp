// SPDX-License-Identifier: Apache-2.0
#include "quality/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/parallel.h"
#include "core/periodic_image.h"
#include "quality/cell_corners.h"
#include "quality/first_heights.h"
#include "quality/gates.h"
#include "quality/smoothness.h"

namespace hexweave {
namespace {

/// Enters one cell's corners into the measure of its zone.
void include_cell(const PointField& x, const Node& cell, const Vec3& plane, ZoneMeasure& zone) {
    bool folded = false;
    for (const CellCorner& corner : cell_corners(x, cell, plane)) {
        zone.pole_corners += corner.at_pole;
        zone.flat_corners += corner.flat;
        if (corner.counted_apart()) continue;
        folded |= corner.folds();
        const double value = corner.scaled_jacobian;
        if (!(value >= zone.worst_scaled_jacobian)) {
            zone.worst_scaled_jacobian = value;
            zone.worst_cell = cell;
            zone.worst_place = x(corner.node[0], corner.node[1], corner.node[2]);
        }
        if (corner.inside && !(value >= zone.worst_inside)) zone.worst_inside = value;
    }
    zone.folded += folded;
}

void measure_cells(const PointField& x, const Vec3& plane, ZoneMeasure& zone) {
    const Extent e = x.extent();
    for (int k = 0; k < std::max(e.nk - 1, 1); ++k) {
        for (int j = 0; j + 1 < e.nj; ++j) {
            for (int i = 0; i + 1 < e.ni; ++i) include_cell(x, {i, j, k}, plane, zone);
        }
    }
}

/// Whether a node is that of the donor, to the last bit; across a periodic interface, whether its
/// image is, but for the round-off where other interfaces lead to the same node.
bool matches(const Vec3& own, const Vec3& donor, const std::optional<PeriodicMap>& map,
             double epsilon) {
    if (!map) return own == donor;
    return distance(image(*map, own), donor) <= image_rounding(*map, own, epsilon);
}

std::size_t count_mismatched(const MultiblockGrid& grid, const Interface& interface,
                             double epsilon) {
    const PointField& own = grid.zones[static_cast<std::size_t>(interface.zone)].points;
    const PointField& donor = grid.zones[static_cast<std::size_t>(interface.donor)].points;
    std::optional<PeriodicMap> map;
    if (interface.periodic) map = periodic_map(*interface.periodic);
    std::size_t mismatched = 0;
    const IndexBox& box = interface.box;
    for (int k = box.begin[2]; k <= box.end[2]; ++k) {
        for (int j = box.begin[1]; j <= box.end[1]; ++j) {
            for (int i = box.begin[0]; i <= box.end[0]; ++i) {
                const Node other = donor_node(interface, {i, j, k});
                if (!matches(own(i, j, k), donor(other[0], other[1], other[2]), map, epsilon))
                    ++mismatched;
            }
        }
    }
    return mismatched;
}

std::vector<SpacingMeasure> measure_spacings(const Topology& topology,
                                             const std::vector<EdgeGrid>& edges) {
    std::vector<SpacingMeasure> rows(edges.size());
    parallel_for(edges.size(), [&](std::size_t e) {
        const Edge& edge = topology.edges[e];
        rows[e] = {edge.name,
                   edge.cells,
                   edge.length,
                   edge.asked_start,
                   edge.asked_end,
                   first_law_cell(edge, edges[e]),
                   last_law_cell(edge, edges[e]),
                   first_cell(edge, edges[e]),
                   last_cell(edge, edges[e]),
                   edges[e].points.front(),
                   edges[e].points.back()};
    });
    return rows;
}

/// Which side of its zone a part of a boundary lies on.
std::optional<Side> side_of(const IndexBox& box, const Zone& zone) {
    const Extent e = zone.points.extent();
    for (const Side side : all_sides) {
        const auto axis = static_cast<std::size_t>(axis_of(side));
        const int last = e[axis_of(side)] - 1;
        if (last == 0 || box.begin[axis] != box.end[axis]) continue;
        if (box.begin[axis] == (is_max(side) ? last : 0)) return side;
    }
    return std::nullopt;
}

std::string side_text(const IndexBox& box, const Zone& zone) {
    const std::optional<Side> side = side_of(box, zone);
    return (side ? std::string(side_name(*side)) + " of " : "") + "'" + zone.name + "'";
}

/// The face of a planar topology whose side lies there, unless the sweep made it.
const Face* face_at(const Topology& topology, const Zone& zone, const std::optional<Side>& side) {
    if (topology.is_3d() || !side || axis_of(*side) == 2) return nullptr;
    const auto found = std::find_if(topology.faces.begin(), topology.faces.end(),
                                    [&](const Face& face) { return face.name == zone.name; });
    return found == topology.faces.end() ? nullptr : &*found;
}

/// Whether `orthogonal` at both of its sides is left to be asked.
bool may_be_straightened(const Topology& topology, const MultiblockGrid& grid,
                         const Interface& interface) {
    bool asked_at_both = true;
    for (const auto& [zone, box] : {std::pair(interface.zone, interface.box),
                                    std::pair(interface.donor, interface.donor_box)}) {
        const Zone& own = grid.zones[static_cast<std::size_t>(zone)];
        const std::optional<Side> side = side_of(box, own);
        const Face* face = face_at(topology, own, side);
        if (face == nullptr) return false;
        asked_at_both &= face->orthogonal[static_cast<std::size_t>(*side)];
    }
    return !asked_at_both;
}

/// The interface without the nodes at its ends, where a line across it may turn a corner; none
/// where nothing is left.
std::optional<Interface> without_ends(const Interface& interface, const Extent& extent) {
    Interface inner = interface;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool is_thin = extent[static_cast<int>(axis)] <= 2;
        if (is_thin || interface.box.begin[axis] == interface.box.end[axis]) continue;
        if (++inner.box.begin[axis] > --inner.box.end[axis]) return std::nullopt;
    }
    inner.donor_box.begin = donor_node(interface, inner.box.begin);
    inner.donor_box.end = donor_node(interface, inner.box.end);
    return inner;
}

}  // namespace

ZoneMeasure measure_zone(const Zone& zone, int physical_dimension) {
    ZoneMeasure measure;
    measure.name = zone.name;
    measure.extent = zone.points.extent();
    measure.cells = measure.extent.cells();
    measure.worst_place = zone.points[0];  // until a corner is worse than perfect
    measure.angles = measure_angles(zone.points);
    measure.growth = measure_growth(zone.points);
    measure_cells(zone.points, zone_plane(zone.points, physical_dimension), measure);
    return measure;
}

InterfaceMeasure measure_interface(const MultiblockGrid& grid, const Interface& interface,
                                   double epsilon) {
    const Zone& own = grid.zones[static_cast<std::size_t>(interface.zone)];
    const Zone& donor = grid.zones[static_cast<std::size_t>(interface.donor)];
    InterfaceMeasure measure{interface.name, count_mismatched(grid, interface, epsilon),
                             measure_growth(grid, interface), interface.periodic.has_value()};
    measure.sides = {side_text(interface.box, own), side_text(interface.donor_box, donor)};
    if (const auto inner = without_ends(interface, own.points.extent())) {
        const BendMeasure bends = measure_bends(grid, *inner);
        measure.bend = bends.greatest;
        measure.bend_place = bends.place;
    }
    return measure;
}

Report measure(const Topology& topology, const std::vector<EdgeGrid>& edges,
               const std::vector<FaceGrid>& faces, const std::vector<BlockGrid>& blocks,
               const MultiblockGrid& grid) {
    Report report;
    report.title = grid.title;
    report.zones.resize(grid.zones.size());
    parallel_for(grid.zones.size(), [&](std::size_t z) {
        report.zones[z] = measure_zone(grid.zones[z], grid.physical_dimension);
    });
    for (const Zone& zone : grid.zones) {
        report.cells += zone.points.extent().cells();
        report.nodes += zone.points.extent().nodes();
    }
    for (const Interface& interface : grid.interfaces) {
        report.interfaces.push_back(measure_interface(grid, interface));
        report.interfaces.back().may_be_straightened =
            may_be_straightened(topology, grid, interface);
    }
    report.walls = measure_walls(grid);
    report.spacings = measure_spacings(topology, edges);
    for (const PutOnSurface& put : topology.put_on_surface) {
        report.put_on_surface.push_back({put.what, put.surfaces, put.distance, put.place});
    }
    const AskingWalls walls{topology, edges, grid};
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const Face& face = topology.faces[f];
        report.solves.push_back({face.name,
                                 false,
                                 face.extent(),
                                 faces[f].solve,
                                 {},
                                 first_heights(topology.is_3d() ? nullptr : &walls, f,
                                               faces[f].points, faces[f].heights),
                                 faces[f].off_surface});
        for (std::size_t corner = 0; corner < 4; ++corner) {
            if (!faces[f].flat_corners[corner]) continue;
            const auto vertex = static_cast<std::size_t>(face.corners[corner]);
            report.solves.back().flat_at.push_back(topology.vertices[vertex].name);
        }
    }
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        report.solves.push_back({topology.blocks[b].name, true, topology.blocks[b].extent,
                                 blocks[b].solve, blocks[b].flat_edges,
                                 first_heights(&walls, b, blocks[b].points, blocks[b].heights)});
    }
    report.gates = judge_gates(topology, faces, grid, report);
    return report;
}

}  // namespace hexweave
