// SPDX-License-Identifier: Apache-2.0
#include "edges/edge_grid.h"

#include <cstddef>
#include <optional>
#include <variant>

#include "core/assert.h"
#include "core/coordinate.h"
#include "core/parallel.h"
#include "edges/spacing.h"
#include "geometry/curve.h"
#include "geometry/stretching.h"

namespace hexweave {

namespace {

/// The edge that a chain of SameAs laws ends at, and whether its fractions are to be reversed.
EdgeUse origin_of_spacing(const Topology& topology, std::size_t edge) {
    EdgeUse use{static_cast<int>(edge), false};
    for (std::size_t steps = 0; steps <= topology.edges.size(); ++steps) {
        const Edge& at = topology.edges[static_cast<std::size_t>(use.edge)];
        const auto* same = std::get_if<SameAs>(&at.law);
        if (!same) return use;
        use = {same->edge, use.reversed != same->reversed};
    }
    HEXWEAVE_ASSERT(false);  // the laws go round in a circle
    return use;
}

/// The arc-length fractions of positions given as fractions of the parameter.
std::vector<double> fractions_of_parameters(const Edge& edge, const std::vector<double>& positions,
                                            const ArcLengthTable& table) {
    std::vector<double> fractions = positions;
    for (std::size_t i = 1; i + 1 < positions.size(); ++i) {
        const double parameter = edge.from + positions[i] * (edge.to - edge.from);
        fractions[i] = table.length_to(parameter) / table.length();
    }
    return fractions;
}

/// The fractions of an edge that has a law of its own.
std::vector<double> own_fractions(const Edge& edge, const ArcLengthTable& table) {
    std::vector<double> positions =
        law_fractions(edge.law, edge.cells / edge.refinement, table.length(), edge.refinement);
    const auto* stated = std::get_if<ExplicitLaw>(&edge.law);
    if (stated && stated->of_parameter) return fractions_of_parameters(edge, positions, table);
    return positions;
}

/// Moves a point onto the edge's planes, and onto z = 0 in a planar topology.
Vec3 on_planes(Vec3 point, const Edge& edge, bool planar) {
    for (const AxisPlane& plane : edge.planes) {
        coordinate(point, plane.axis) = plane.value;
    }
    if (planar) point.z = 0;
    return point;
}

/// Points and parameters at the grid's fractions.
void place_points(const Topology& topology, const Edge& edge, const ArcLengthTable& table,
                  EdgeGrid& grid) {
    const std::size_t count = grid.fractions.size();
    grid.parameters.resize(count);
    grid.points.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        grid.parameters[i] = table.parameter_at(grid.fractions[i] * table.length());
        grid.points[i] =
            on_planes(evaluate(*edge.curve, grid.parameters[i]), edge, topology.planar);
    }
    grid.parameters.front() = edge.from;
    grid.parameters.back() = edge.to;
    const auto law_cell = static_cast<std::size_t>(edge.refinement);
    grid.law_cells = {grid.parameters[law_cell], grid.parameters[count - 1 - law_cell]};
    grid.points.front() = topology.vertices[static_cast<std::size_t>(edge.start)].position;
    grid.points.back() = topology.vertices[static_cast<std::size_t>(edge.end)].position;
}

/// All points of a pole are its vertex; its fractions are those of equal steps.
EdgeGrid pole_grid(const Topology& topology, const Edge& edge) {
    EdgeGrid grid;
    grid.fractions = law_fractions(UniformLaw{}, edge.cells, 1);
    grid.parameters = grid.fractions;
    grid.points.assign(grid.fractions.size(),
                       topology.vertices[static_cast<std::size_t>(edge.start)].position);
    return grid;
}

/// The points of an edge that is the image of another one, whose points are known. Its ends are its
/// vertices, which are images too.
void place_image(const Topology& topology, const Edge& edge, const EdgeGrid& of, EdgeGrid& grid) {
    const PeriodicMap map = image_map(topology, *edge.image);
    const std::size_t last = grid.points.size() - 1;
    for (std::size_t i = 1; i < last; ++i) {
        const Vec3& point = of.points[edge.image->reversed() ? last - i : i];
        grid.points[i] = on_planes(image(map, point), edge, topology.planar);
    }
}

/// Carries points over to images, and from there on to images of these.
void place_images(const Topology& topology, std::vector<EdgeGrid>& grids) {
    std::vector<bool> done(grids.size());
    const auto place = [&](std::size_t e, const auto& recurse) -> void {
        const Edge& edge = topology.edges[e];
        if (done[e] || !edge.image) return;
        done[e] = true;
        const auto of = static_cast<std::size_t>(edge.image->of);
        recurse(of, recurse);
        place_image(topology, edge, grids[of], grids[e]);
    };
    for (std::size_t e = 0; e < grids.size(); ++e) place(e, place);
}

}  // namespace

std::vector<EdgeGrid> make_edges(const Topology& topology) {
    const std::size_t count = topology.edges.size();
    std::vector<EdgeGrid> grids(count);
    std::vector<std::optional<ArcLengthTable>> tables(count);
    parallel_for(count, [&](std::size_t e) {
        const Edge& edge = topology.edges[e];
        if (edge.pole) {
            grids[e] = pole_grid(topology, edge);
            return;
        }
        tables[e].emplace(*edge.curve, edge.from, edge.to);
        if (!std::holds_alternative<SameAs>(edge.law)) {
            grids[e].fractions = own_fractions(edge, *tables[e]);
        }
    });
    for (std::size_t e = 0; e < count; ++e) {
        const EdgeUse origin = origin_of_spacing(topology, e);
        const std::vector<double>& own = grids[static_cast<std::size_t>(origin.edge)].fractions;
        if (static_cast<std::size_t>(origin.edge) == e) continue;
        grids[e].fractions = origin.reversed ? reversed_fractions(own) : own;
    }
    parallel_for(count, [&](std::size_t e) {
        if (tables[e]) place_points(topology, topology.edges[e], *tables[e], grids[e]);
    });
    place_images(topology, grids);
    return grids;
}

double first_cell(const Edge& edge, const EdgeGrid& grid) {
    if (edge.pole) return 0;
    return arc_length(*edge.curve, grid.parameters[0], grid.parameters[1]);
}

double last_cell(const Edge& edge, const EdgeGrid& grid) {
    if (edge.pole) return 0;
    const std::size_t last = grid.parameters.size() - 1;
    return arc_length(*edge.curve, grid.parameters[last - 1], grid.parameters[last]);
}

double first_law_cell(const Edge& edge, const EdgeGrid& grid) {
    return edge.pole ? 0 : arc_length(*edge.curve, grid.parameters.front(), grid.law_cells[0]);
}

double last_law_cell(const Edge& edge, const EdgeGrid& grid) {
    return edge.pole ? 0 : arc_length(*edge.curve, grid.law_cells[1], grid.parameters.back());
}

EdgeGrid every_nth(const EdgeGrid& grid, int stride) {
    EdgeGrid result;
    result.law_cells = grid.law_cells;
    for (std::size_t i = 0; i < grid.points.size(); i += static_cast<std::size_t>(stride)) {
        result.points.push_back(grid.points[i]);
        result.parameters.push_back(grid.parameters[i]);
        result.fractions.push_back(grid.fractions[i]);
    }
    return result;
}

}  // namespace hexweave
