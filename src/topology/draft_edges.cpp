// SPDX-License-Identifier: Apache-2.0
// Vertices and drawn edges: where they are.
#include <fmt/format.h>

#include <memory>
#include <utility>
#include <vector>

#include "geometry/lines.h"
#include "topology/curve_pieces.h"
#include "topology/draft.h"
#include "topology/sample.h"
#include "topology/text.h"

namespace hexweave {

namespace {

/// A vertex may be this far from the curve that an edge follows, in sizes of the curve.
constexpr double on_curve = 1e-6;
/// An edge shorter than this, in sizes of its curve (of all vertices), has no length.
constexpr double no_length = 1e-12;

/// Finds the curve, marks it used; null where it is unknown or could not be built.
const CurveEntry* use_curve(Draft& draft, const Name& name) {
    const std::optional<int> index = draft.curve_names.require(name, draft.diagnostics);
    if (!index) return nullptr;
    draft.curve_used[static_cast<std::size_t>(*index)] = true;
    const CurveEntry& entry = draft.c.curves[static_cast<std::size_t>(*index)];
    return entry.shape ? &entry : nullptr;
}

/// The parameters at which an edge's curve passes one of its vertices; empty after an error.
std::vector<double> vertex_parameters(Draft& draft, const EdgeEntry& edge, const CurveEntry& along,
                                      const DraftVertex& vertex, const Place& place) {
    const Curve& curve = *along.shape;
    const bool put = !edge.surfaces.empty();
    if (const auto* where = std::get_if<OnCurve>(&vertex.entry->where)) {
        if (where->curve.value == along.name.value && !put) {
            return passings(curve, parameter_at_fraction(curve, where->at));
        }
    }
    const CurvePoint foot = project(curve, vertex.vertex.position);
    if (!(foot.distance <= edge.gap.value_or(on_curve * size_of(curve)))) {
        if (put) {
            draft.diagnostics.error(
                place,
                fmt::format("vertex {} is not on the curve {} as put onto {}: it is {} away",
                            quoted(vertex.vertex.name), quoted(along.name.value),
                            surfaces_text(edge.surfaces), number_text(foot.distance)),
                fmt::format("the nearest point of it is {}", point_text(foot.position)));
            return {};
        }
        const double whole = arc_length(curve, curve.begin, curve.end);
        const double at = arc_length(curve, curve.begin, foot.parameter) / whole;
        draft.diagnostics.error(
            place,
            fmt::format("vertex {} is not on the curve {}: it is {} away",
                        quoted(vertex.vertex.name), quoted(along.name.value),
                        number_text(foot.distance)),
            fmt::format("the nearest point of the curve is {{curve: {}, at: {}}}, at {}",
                        along.name.value, number_text(at), point_text(foot.position)));
        return {};
    }
    return passings(curve, foot.parameter);
}

/// Picks the piece that 'through' lies on; nullopt after an error.
std::optional<CurvePiece> pick_piece(Draft& draft, const EdgeEntry& entry, const Curve& curve,
                                     const std::vector<CurvePiece>& pieces) {
    if (entry.through) {
        // Near is enough, but a point that could be anywhere else was meant for another curve.
        constexpr double near = 0.25;
        const CurvePoint foot = project(curve, entry.through->value);
        if (!(foot.distance <= near * size_of(curve))) {
            draft.diagnostics.error(
                entry.through->place,
                fmt::format("'through' is {} away from the curve {}", number_text(foot.distance),
                            quoted(entry.along->value)),
                fmt::format("the nearest point of the curve is {}", point_text(foot.position)));
            return std::nullopt;
        }
        for (const CurvePiece& piece : pieces) {
            if (passes(curve, piece, foot.parameter)) return piece;
        }
        draft.diagnostics.error(
            entry.through->place,
            fmt::format("'through' does not lie between {} and {} on the curve {}",
                        quoted(entry.from.value), quoted(entry.to.value),
                        quoted(entry.along->value)),
            "give a point of the curve between the two");
        return std::nullopt;
    }
    if (pieces.size() == 1) return pieces.front();
    const auto middle = [&](const CurvePiece& p) {
        return point_text(evaluate(curve, (p.from + p.to) / 2));
    };
    draft.diagnostics.error(
        entry.along->place,
        fmt::format("two ways lead from {} to {} along {}, a closed curve",
                    quoted(entry.from.value), quoted(entry.to.value), quoted(entry.along->value)),
        fmt::format("pick one by a point on it: 'through: {}' or 'through: {}'", middle(pieces[0]),
                    middle(pieces[1])));
    return std::nullopt;
}

bool place_on_curve(Draft& draft, DraftEdge& edge, const CurveEntry& along) {
    const EdgeEntry& entry = *edge.entry;
    const Curve& curve = *along.shape;
    const DraftVertex& start = draft.vertex(edge.edge.start);
    const DraftVertex& end = draft.vertex(edge.edge.end);
    if (!start.sound || !end.sound) return false;
    const std::vector<double> from =
        vertex_parameters(draft, entry, along, start, entry.from.place);
    const std::vector<double> to = vertex_parameters(draft, entry, along, end, entry.to.place);
    if (from.empty() || to.empty()) return false;
    const bool loop = edge.edge.start == edge.edge.end;
    const std::vector<CurvePiece> pieces = pieces_between(curve, from, to, loop);
    if (pieces.empty()) {
        draft.diagnostics.error(
            entry.name.place,
            loop ? fmt::format("edge {} goes from {} to itself, but {} is not a closed curve",
                               quoted(entry.name.value), quoted(entry.from.value),
                               quoted(entry.along->value))
                 : fmt::format("edge {} has no length: {} and {} are the same place on {}",
                               quoted(entry.name.value), quoted(entry.from.value),
                               quoted(entry.to.value), quoted(entry.along->value)),
            loop
                ? "name two vertices, or a closed curve"
                : "name two different vertices; an edge that is one point is a pole, {at: VERTEX}");
        return false;
    }
    if (loop && entry.through) {
        draft.diagnostics.error(entry.through->place,
                                fmt::format("'through' picks nothing: edge {} runs once round {}",
                                            quoted(entry.name.value), quoted(entry.along->value)),
                                "leave 'through' out");
        return false;
    }
    const std::optional<CurvePiece> piece = pick_piece(draft, entry, curve, pieces);
    if (!piece) return false;
    edge.edge.curve = along.shape;
    edge.edge.from = piece->from;
    edge.edge.to = piece->to;
    edge.edge.length = arc_length(curve, piece->from, piece->to);
    if (edge.edge.length > no_length * size_of(curve)) return true;
    draft.diagnostics.error(entry.name.place,
                            fmt::format("edge {} has no length", quoted(entry.name.value)),
                            "name two vertices farther apart");
    return false;
}

double vertices_size(const Draft& draft) {
    std::vector<Vec3> points;
    for (const DraftVertex& v : draft.vertices) {
        if (v.sound) points.push_back(v.vertex.position);
    }
    return box_around(points).diagonal();
}

/// Places an edge on a curve that is first put onto the edge's surfaces.
bool place_on_put_curve(Draft& draft, DraftEdge& edge, const CurveEntry& along) {
    CurveEntry put = along;
    put.shape = put_onto_surfaces(draft, *along.shape, *edge.entry);
    if (!put.shape || !place_on_curve(draft, edge, put)) return false;
    note_put_edge(draft, edge, *along.shape);
    return true;
}

/// Whether an edge that follows no curve can be one.
bool check_straight(Draft& draft, const DraftEdge& edge) {
    const EdgeEntry& entry = *edge.entry;
    if (entry.through) {
        draft.diagnostics.error(entry.through->place,
                                fmt::format("'through' picks a way along a closed curve, but edge "
                                            "{} is a straight line",
                                            quoted(entry.name.value)),
                                "name the curve with 'along', or leave 'through' out");
        return false;
    }
    if (edge.edge.start == edge.edge.end) {
        draft.diagnostics.error(entry.name.place,
                                fmt::format("edge {} goes from {} to itself in a straight line",
                                            quoted(entry.name.value), quoted(entry.from.value)),
                                "name the closed curve that it follows with 'along'");
        return false;
    }
    return true;
}

bool place_straight(Draft& draft, DraftEdge& edge) {
    if (!check_straight(draft, edge)) return false;
    const EdgeEntry& entry = *edge.entry;
    const DraftVertex& start = draft.vertex(edge.edge.start);
    const DraftVertex& end = draft.vertex(edge.edge.end);
    if (!start.sound || !end.sound) return false;
    if (distance(start.vertex.position, end.vertex.position) > no_length * vertices_size(draft)) {
        make_straight(edge.edge, start.vertex.position, end.vertex.position);
        return true;
    }
    draft.diagnostics.error(
        entry.name.place,
        fmt::format("edge {} has no length: {} and {} are the same place", quoted(entry.name.value),
                    quoted(entry.from.value), quoted(entry.to.value)),
        "name one vertex in both places, or move one; an edge that is one point is a pole, {at: "
        "VERTEX}");
    return false;
}

/// A pole is a line without a length, at its vertex.
void place_pole(Draft& draft, DraftEdge& edge) {
    const DraftVertex& vertex = draft.vertex(edge.edge.start);
    make_straight(edge.edge, vertex.vertex.position, vertex.vertex.position);
    edge.edge.pole = true;
    edge.sound = vertex.sound;
}

int use_vertex(Draft& draft, const Name& name) {
    const std::optional<int> index = draft.vertex_names.require(name, draft.diagnostics);
    if (!index) return -1;
    draft.vertex(*index).used = true;
    return *index;
}

}  // namespace

void make_straight(Edge& edge, const Vec3& start, const Vec3& end) {
    edge.curve = std::make_shared<const Curve>(straight_line(start, end));
    edge.from = 0;
    edge.to = 1;
    edge.length = distance(start, end);
}

void place_vertices(Draft& draft) {
    draft.curve_used.assign(draft.c.curves.size(), false);
    for (std::size_t n = 0; n < draft.c.curves.size(); ++n) {
        draft.curve_names.add(draft.c.curves[n].name.value, static_cast<int>(n));
        draft.curve_used[n] = draft.c.curves[n].used_by_curve;
    }
    draft.surface_used.assign(draft.c.surfaces.size(), false);
    for (std::size_t n = 0; n < draft.c.surfaces.size(); ++n) {
        draft.surface_names.add(draft.c.surfaces[n].name.value, static_cast<int>(n));
        draft.surface_used[n] = draft.c.surfaces[n].used_by_surface;
    }
    for (const VertexEntry& entry : draft.c.vertices) {
        draft.vertex_names.add(entry.name.value, static_cast<int>(draft.vertices.size()));
        DraftVertex vertex;
        vertex.vertex.name = entry.name.value;
        vertex.vertex.place = entry.name.place;
        vertex.entry = &entry;
        if (const auto* position = std::get_if<Vec3>(&entry.where)) {
            vertex.vertex.position = *position;
            vertex.sound = true;
        } else if (const auto* place = std::get_if<OnSurface>(&entry.where)) {
            place_on_surface(draft, vertex, *place);
        } else {
            const auto& where = std::get<OnCurve>(entry.where);
            if (const CurveEntry* curve = use_curve(draft, where.curve)) {
                const Curve& shape = *curve->shape;
                vertex.vertex.position = evaluate(shape, parameter_at_fraction(shape, where.at));
                vertex.sound = true;
            }
        }
        draft.vertices.push_back(std::move(vertex));
    }
}

void place_edges(Draft& draft) {
    for (const EdgeEntry& entry : draft.c.edges) {
        draft.edge_names.add(entry.name.value, static_cast<int>(draft.edges.size()));
        DraftEdge edge;
        edge.edge.name = entry.name.value;
        edge.edge.place = entry.name.place;
        edge.entry = &entry;
        edge.edge.start = use_vertex(draft, entry.from);
        edge.edge.end = use_vertex(draft, entry.to);
        if (entry.pole) {
            if (edge.edge.start >= 0) place_pole(draft, edge);
            draft.edges.push_back(std::move(edge));
            continue;
        }
        const CurveEntry* along = entry.along ? use_curve(draft, *entry.along) : nullptr;
        if (edge.edge.start >= 0 && edge.edge.end >= 0) {
            if (along != nullptr) {
                edge.sound = entry.surfaces.empty() ? place_on_curve(draft, edge, *along)
                                                    : place_on_put_curve(draft, edge, *along);
            } else if (!entry.along && !entry.surfaces.empty()) {
                edge.sound = check_straight(draft, edge) && place_across_surfaces(draft, edge);
            } else if (!entry.along) {
                edge.sound = place_straight(draft, edge);
            }
        }
        draft.edges.push_back(std::move(edge));
    }
}

}  // namespace hexweave
