// SPDX-License-Identifier: Apache-2.0
#include "quality/measure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"

namespace hexweave {
namespace {

// A corner is folded when its scaled Jacobian is not above this.
constexpr double fold_limit = 1e-9;
// Where two sides of a zone meet at more than this angle, a corner may be flat.
const double flat_cosine = std::cos(150.0 / 180.0 * std::acos(-1.0));

double scaled(double value, double scale) {
    return scale > 0 ? value / scale : 0;
}

/// The direction that leads from a corner node into its cell along an axis: +1 at the low end.
using Inward = std::array<int, 3>;

Vec3 leg(const PointField& x, const Node& corner, const Inward& inward, int axis) {
    Node other = corner;
    other[static_cast<std::size_t>(axis)] += inward[static_cast<std::size_t>(axis)];
    return x(other[0], other[1], other[2]) - x(corner[0], corner[1], corner[2]);
}

bool on_side(const Node& node, const Extent& extent, int axis) {
    const int index = node[static_cast<std::size_t>(axis)];
    return index == 0 || index == extent[axis] - 1;
}

/// Whether the two sides that meet at this corner along the zone edge `edge` (a zero vector in two
/// dimensions) do so at more than 150 degrees, seen along that edge.
bool sides_meet_flat(Vec3 a, Vec3 b, const Vec3& edge) {
    const double length = dot(edge, edge);
    if (length > 0) {
        a -= (dot(a, edge) / length) * edge;
        b -= (dot(b, edge) / length) * edge;
    }
    const double scale = norm(a) * norm(b);
    return scale > 0 && dot(a, b) < flat_cosine * scale;
}

/// Whether a corner lies at a pole: a leg along a side of the zone has no length.
bool is_at_pole(const Node& node, const Extent& extent, const std::array<Vec3, 3>& legs) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(legs[static_cast<std::size_t>(axis)] == Vec3{}) || extent[axis] == 1) continue;
        for (int other = 0; other < 3; ++other) {
            if (other != axis && extent[other] > 1 && on_side(node, extent, other)) return true;
        }
    }
    return false;
}

/// Collects the corners of one zone's cells.
struct Collector {
    ZoneMeasure& zone;

    /// Returns whether the corner folds its cell.
    bool corner(double scaled_jacobian, bool may_be_flat, bool inside, const Node& cell,
                const Vec3& place) {
        // A corner that is turned inside out is folded wherever it lies; "flat" means flat.
        if (may_be_flat && std::abs(scaled_jacobian) <= fold_limit) {
            ++zone.flat_corners;
            return false;
        }
        if (!(scaled_jacobian >= zone.worst_scaled_jacobian)) {
            zone.worst_scaled_jacobian = scaled_jacobian;
            zone.worst_cell = cell;
            zone.worst_place = place;
        }
        if (inside && !(scaled_jacobian >= zone.worst_inside)) zone.worst_inside = scaled_jacobian;
        return !(scaled_jacobian > fold_limit);
    }
};

/// The unit normal that a surface cell's corners are measured against: +z in the plane, else the
/// cell's own mean normal.
Vec3 cell_normal(const PointField& x, int i, int j, bool planar) {
    if (planar) return {0, 0, 1};
    const Vec3 normal = cross(x(i + 1, j + 1) - x(i, j), x(i, j + 1) - x(i + 1, j));
    const double length = norm(normal);
    return length > 0 ? normal / length : Vec3{};
}

void measure_surface(const PointField& x, bool planar, ZoneMeasure& zone) {
    const Extent extent = x.extent();
    Collector collect{zone};
    for (int j = 0; j + 1 < extent.nj; ++j) {
        for (int i = 0; i + 1 < extent.ni; ++i) {
            const Vec3 normal = cell_normal(x, i, j, planar);
            bool folded = false;
            for (int c = 0; c < 4; ++c) {
                const Node node{i + c % 2, j + c / 2, 0};
                const Inward inward{c % 2 == 0 ? 1 : -1, c / 2 == 0 ? 1 : -1, 0};
                const Vec3 a = leg(x, node, inward, 0);
                const Vec3 b = leg(x, node, inward, 1);
                if (is_at_pole(node, extent, {a, b, {}})) {
                    ++zone.pole_corners;
                    continue;
                }
                const double value =
                    scaled(inward[0] * inward[1] * dot(normal, cross(a, b)), norm(a) * norm(b));
                const bool may_be_flat = on_side(node, extent, 0) && on_side(node, extent, 1) &&
                                         sides_meet_flat(a, b, {});
                const bool inside = !on_side(node, extent, 0) && !on_side(node, extent, 1);
                folded |=
                    collect.corner(value, may_be_flat, inside, {i, j, 0}, x(node[0], node[1]));
            }
            if (folded) ++zone.folded;
        }
    }
}

/// Whether one of the zone edges through this corner node is a flat one.
bool on_flat_edge(const Node& node, const Extent& extent, const std::array<Vec3, 3>& legs) {
    for (int axis = 0; axis < 3; ++axis) {
        const int first = (axis + 1) % 3;
        const int second = (axis + 2) % 3;
        if (on_side(node, extent, first) && on_side(node, extent, second) &&
            sides_meet_flat(legs[static_cast<std::size_t>(first)],
                            legs[static_cast<std::size_t>(second)],
                            legs[static_cast<std::size_t>(axis)])) {
            return true;
        }
    }
    return false;
}

bool cell_is_folded(const PointField& x, const Node& cell, Collector& collect) {
    bool folded = false;
    for (int c = 0; c < 8; ++c) {
        const std::array<int, 3> high{c & 1, (c >> 1) & 1, (c >> 2) & 1};
        const Node node{cell[0] + high[0], cell[1] + high[1], cell[2] + high[2]};
        const Inward inward{1 - 2 * high[0], 1 - 2 * high[1], 1 - 2 * high[2]};
        const std::array<Vec3, 3> legs{leg(x, node, inward, 0), leg(x, node, inward, 1),
                                       leg(x, node, inward, 2)};
        if (is_at_pole(node, x.extent(), legs)) {
            ++collect.zone.pole_corners;
            continue;
        }
        const double sign = inward[0] * inward[1] * inward[2];
        const double value = scaled(sign * triple(legs[0], legs[1], legs[2]),
                                    norm(legs[0]) * norm(legs[1]) * norm(legs[2]));
        const bool inside = !on_side(node, x.extent(), 0) && !on_side(node, x.extent(), 1) &&
                            !on_side(node, x.extent(), 2);
        folded |= collect.corner(value, on_flat_edge(node, x.extent(), legs), inside, cell,
                                 x(node[0], node[1], node[2]));
    }
    return folded;
}

void measure_volume(const PointField& x, ZoneMeasure& zone) {
    const Extent extent = x.extent();
    Collector collect{zone};
    for (int k = 0; k + 1 < extent.nk; ++k) {
        for (int j = 0; j + 1 < extent.nj; ++j) {
            for (int i = 0; i + 1 < extent.ni; ++i) {
                if (cell_is_folded(x, {i, j, k}, collect)) ++zone.folded;
            }
        }
    }
}

std::size_t count_mismatched(const MultiblockGrid& grid, const Interface& interface) {
    const PointField& own = grid.zones[static_cast<std::size_t>(interface.zone)].points;
    const PointField& donor = grid.zones[static_cast<std::size_t>(interface.donor)].points;
    std::size_t mismatched = 0;
    const IndexBox& box = interface.box;
    for (int k = box.begin[2]; k <= box.end[2]; ++k) {
        for (int j = box.begin[1]; j <= box.end[1]; ++j) {
            for (int i = box.begin[0]; i <= box.end[0]; ++i) {
                const Node other = donor_node(interface, {i, j, k});
                if (!(own(i, j, k) == donor(other[0], other[1], other[2]))) ++mismatched;
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
                   first_cell(edge, edges[e]),
                   last_cell(edge, edges[e])};
    });
    return rows;
}

std::vector<HeightMeasure> measure_heights(const PointField& points,
                                           const std::vector<HeldSide>& sides) {
    std::vector<HeightMeasure> rows;
    for (const HeldSide& held : sides) {
        const std::vector<double> ratios = height_ratios(points, held);
        const double* const asked = held.asked.data();
        const auto [least, greatest] =
            std::minmax_element(asked, asked + held.asked.extent().nodes());
        rows.push_back({held.side, *least, *greatest, ratios.front(), ratios[ratios.size() / 2],
                        ratios.back()});
    }
    return rows;
}

}  // namespace

ZoneMeasure measure_zone(const Zone& zone, int physical_dimension) {
    ZoneMeasure measure;
    measure.name = zone.name;
    measure.extent = zone.points.extent();
    measure.cells = measure.extent.cells();
    measure.angles = measure_angles(zone.points);
    measure.growth = measure_growth(zone.points);
    if (measure.extent.nk == 1) {
        measure_surface(zone.points, physical_dimension == 2, measure);
    } else {
        measure_volume(zone.points, measure);
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
        report.interfaces.push_back(
            {interface.name, count_mismatched(grid, interface), measure_growth(grid, interface)});
    }
    report.walls = measure_walls(grid);
    report.spacings = measure_spacings(topology, edges);
    for (const PutOnSurface& put : topology.put_on_surface) {
        report.put_on_surface.push_back({put.what, put.surfaces, put.distance, put.place});
    }
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const Face& face = topology.faces[f];
        report.solves.push_back({face.name,
                                 false,
                                 face.extent(),
                                 faces[f].solve,
                                 {},
                                 measure_heights(faces[f].points, faces[f].heights),
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
                                 measure_heights(blocks[b].points, blocks[b].heights)});
    }
    return report;
}

}  // namespace hexweave
