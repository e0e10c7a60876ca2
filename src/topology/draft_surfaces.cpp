// SPDX-License-Identifier: Apache-2.0
// Vertices and edges on surfaces: where they are.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/curve_on_surface.h"
#include "geometry/lines.h"
#include "geometry/surface_set.h"
#include "topology/draft.h"
#include "topology/text.h"

namespace hexweave {

namespace {

/// A vertex may be this far from the surface that an edge follows, in sizes of the surface.
constexpr double on_surface = 1e-6;

/// Whether a parameter is on the surface; reports where not. Along a closed parameter one more turn
/// either way is allowed.
bool check_parameter(Draft& draft, const OnSurface& where, const char* name, double value,
                     const std::array<double, 2>& range, bool closed) {
    const double width = range[1] - range[0];
    const double slack = closed ? width : 1e-12 * width;
    if (value >= range[0] - slack && value <= range[1] + slack) return true;
    draft.diagnostics.error(where.place,
                            fmt::format("{} = {} is not on {}", name, number_text(value),
                                        surfaces_text(where.surfaces)),
                            fmt::format("its {} runs from {} to {}", name, number_text(range[0]),
                                        number_text(range[1])));
    return false;
}

bool place_by_parameters(Draft& draft, DraftVertex& vertex, const OnSurface& where,
                         const Surface& surface) {
    const auto& at = std::get<SurfaceParameters>(where.where);
    const bool u = check_parameter(draft, where, "u", at.u, surface.range_u, surface.closed_u);
    const bool v = check_parameter(draft, where, "v", at.v, surface.range_v, surface.closed_v);
    if (!u || !v) return false;
    vertex.vertex.position = evaluate(surface, at);
    return true;
}

/// The parameters of an edge's end on the edge's surface: as stated, or found; none after an error.
std::optional<SurfaceParameters> parameters_of(Draft& draft, const DraftVertex& vertex,
                                               const EdgeEntry& edge, const Place& place,
                                               const SurfaceProjection& projection) {
    if (const auto* where = std::get_if<OnSurface>(&vertex.entry->where)) {
        const auto* stated = std::get_if<SurfaceParameters>(&where->where);
        const bool same = where->surfaces.size() == 1 &&
                          where->surfaces.front().value == edge.surfaces.front().value;
        if (stated != nullptr && same) return *stated;
    }
    const SurfacePoint foot = projection.nearest(vertex.vertex.position);
    if (foot.distance <= edge.gap.value_or(on_surface * projection.size())) {
        return foot.parameters;
    }
    draft.diagnostics.error(
        place,
        fmt::format("vertex {} is not on the {}: it is {} away", quoted(vertex.vertex.name),
                    surfaces_text(edge.surfaces), number_text(foot.distance)),
        fmt::format("the nearest point of the surface is {}, at u = {}, v = {}",
                    point_text(foot.position), number_text(foot.parameters.u),
                    number_text(foot.parameters.v)));
    return std::nullopt;
}

/// At a pole the other end says which way to go.
void take_from_other(const SurfaceProjection& projection, SurfaceParameters& at,
                     const SurfaceParameters& other) {
    constexpr double vanishing = 1e-9;
    const Surface& surface = projection.surface();
    const double least = vanishing * projection.size();
    const auto span = [](const std::array<double, 2>& range) { return range[1] - range[0]; };
    const bool no_u = norm(evaluate_derivative_u(surface, at)) * span(surface.range_u) < least;
    const bool no_v = norm(evaluate_derivative_v(surface, at)) * span(surface.range_v) < least;
    if (no_u) at.u = other.u;
    if (no_v) at.v = other.v;
}

bool follow_parameters(Draft& draft, DraftEdge& edge, const Surface& surface) {
    const EdgeEntry& entry = *edge.entry;
    const SurfaceProjection projection(surface);
    auto from =
        parameters_of(draft, draft.vertex(edge.edge.start), entry, entry.from.place, projection);
    auto to = parameters_of(draft, draft.vertex(edge.edge.end), entry, entry.to.place, projection);
    if (!from || !to) return false;
    const auto* start = std::get_if<OnSurface>(&draft.vertex(edge.edge.start).entry->where);
    const auto* end = std::get_if<OnSurface>(&draft.vertex(edge.edge.end).entry->where);
    const bool stated = start != nullptr && end != nullptr &&
                        std::holds_alternative<SurfaceParameters>(start->where) &&
                        std::holds_alternative<SurfaceParameters>(end->where);
    if (!stated) to = continued(surface, *to, *from);
    take_from_other(projection, *from, *to);
    take_from_other(projection, *to, *from);
    edge.edge.curve = std::make_shared<const Curve>(parameter_line(surface, *from, *to));
    return true;
}

}  // namespace

std::string surfaces_text(const std::vector<Name>& names) {
    std::vector<std::string> list;
    list.reserve(names.size());
    for (const Name& name : names) list.push_back(name.value);
    return fmt::format("surface{} {}", names.size() == 1 ? "" : "s", listed(list));
}

std::vector<std::shared_ptr<const Surface>> use_surfaces(Draft& draft,
                                                         const std::vector<Name>& names) {
    std::vector<std::shared_ptr<const Surface>> surfaces;
    bool found = true;
    for (const Name& name : names) {
        const std::optional<int> index = draft.surface_names.require(name, draft.diagnostics);
        if (!index) {
            found = false;
            continue;
        }
        draft.surface_used[static_cast<std::size_t>(*index)] = true;
        surfaces.push_back(draft.c.surfaces[static_cast<std::size_t>(*index)].shape);
        found = found && surfaces.back();
    }
    if (!found) surfaces.clear();
    return surfaces;
}

void place_on_surface(Draft& draft, DraftVertex& vertex, const OnSurface& where) {
    const auto surfaces = use_surfaces(draft, where.surfaces);
    if (surfaces.empty()) return;
    if (std::holds_alternative<SurfaceParameters>(where.where)) {
        vertex.sound = place_by_parameters(draft, vertex, where, *surfaces.front());
        return;
    }
    const auto& near = std::get<Vec3>(where.where);
    const PatchPoint foot = SurfaceSet(surfaces).nearest(near);
    vertex.vertex.position = foot.point.position;
    vertex.sound = true;
    draft.put_on_surface.push_back(
        {fmt::format("vertex {}", quoted(vertex.vertex.name)),
         surfaces_text({where.surfaces[static_cast<std::size_t>(foot.patch)]}), foot.point.distance,
         near});
}

std::shared_ptr<const Curve> put_onto_surfaces(Draft& draft, const Curve& curve,
                                               const EdgeEntry& entry) {
    const auto surfaces = use_surfaces(draft, entry.surfaces);
    if (surfaces.empty()) return nullptr;
    return std::make_shared<const Curve>(projected_curve(curve, SurfaceSet(surfaces)));
}

void note_put_edge(Draft& draft, const DraftEdge& edge, const Curve& curve) {
    constexpr int samples = 64;
    const double low = std::min(edge.edge.from, edge.edge.to);
    const double high = std::max(edge.edge.from, edge.edge.to);
    // Knots of its parameters, which crowd where the curve bends.
    std::vector<double> places = joints_between(*edge.edge.curve, low, high);
    for (int n = 0; n <= samples; ++n) places.push_back(low + (high - low) * n / samples);
    PutOnSurface put{fmt::format("edge {}", quoted(edge.edge.name)),
                     surfaces_text(edge.entry->surfaces),
                     -1,
                     {}};
    for (const double t : places) {
        const Vec3 before = evaluate(curve, t);
        const double moved = distance(before, evaluate(*edge.edge.curve, t));
        if (moved <= put.distance) continue;
        put.distance = moved;
        put.place = before;
    }
    draft.put_on_surface.push_back(std::move(put));
}

bool place_across_surfaces(Draft& draft, DraftEdge& edge) {
    const EdgeEntry& entry = *edge.entry;
    const DraftVertex& start = draft.vertex(edge.edge.start);
    const DraftVertex& end = draft.vertex(edge.edge.end);
    const auto surfaces = use_surfaces(draft, entry.surfaces);
    if (surfaces.empty() || !start.sound || !end.sound) return false;
    const Vec3 from = start.vertex.position;
    const Vec3 to = end.vertex.position;
    if (surfaces.size() == 1) {
        if (!follow_parameters(draft, edge, *surfaces.front())) return false;
    } else if (distance(from, to) > 0) {
        const SurfaceSet set(surfaces);
        for (const auto& [vertex, place] :
             {std::pair{&start, entry.from.place}, std::pair{&end, entry.to.place}}) {
            const PatchPoint foot = set.nearest(vertex->vertex.position);
            if (foot.point.distance <= entry.gap.value_or(on_surface * set.size())) continue;
            draft.diagnostics.error(
                place,
                fmt::format("vertex {} is on none of the {}: it is {} away",
                            quoted(vertex->vertex.name), surfaces_text(entry.surfaces),
                            number_text(foot.point.distance)),
                fmt::format("the nearest point of them is {}", point_text(foot.point.position)));
            return false;
        }
        edge.edge.curve =
            std::make_shared<const Curve>(projected_curve(straight_line(from, to), set));
    }
    edge.edge.from = 0;
    edge.edge.to = 1;
    if (edge.edge.curve) edge.edge.length = arc_length(*edge.edge.curve, 0, 1);
    if (edge.edge.length > 1e-12 * distance(Vec3{}, from - to) && edge.edge.length > 0) return true;
    draft.diagnostics.error(entry.name.place,
                            fmt::format("edge {} has no length", quoted(entry.name.value)),
                            "name two vertices farther apart");
    return false;
}

}  // namespace hexweave
