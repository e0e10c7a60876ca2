// SPDX-License-Identifier: Apache-2.0
#include "io/report_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace hexweave {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}
Json number(const std::optional<double>& value) {
    return value ? number(*value) : Json(nullptr);
}
Json point(const Vec3& p) {
    return {number(p.x), number(p.y), number(p.z)};
}
Json extent(const Extent& e) {
    return {e.ni, e.nj, e.nk};
}

Json place(const Place& p) {
    return {{"file", p.file ? p.file->name : ""}, {"line", p.line}, {"column", p.column}};
}

Json diagnostic(const Diagnostic& d) {
    Json notes = Json::array();
    for (const Note& n : d.notes) {
        Json note = place(n.place);
        note["message"] = n.message;
        notes.push_back(note);
    }
    Json json{{"severity", d.severity == Severity::error ? "error" : "warning"}};
    json.update(place(d.place));
    json["message"] = d.message;
    json["hint"] = d.hint;
    json["notes"] = notes;
    return json;
}

Json orthogonality(const Orthogonality& o) {
    return {{"passes", o.passes},
            {"passes_asked", o.passes_asked},
            {"edge_cycles", o.edge_cycles},
            {"limited", o.limited},
            {"end", orthogonality_end_name(o.end)}};
}

template <class T, class Convert>
Json list(const std::vector<T>& items, Convert convert) {
    Json array = Json::array();
    for (const T& item : items) array.push_back(convert(item));
    return array;
}

Json held_heights(const HeightMeasure& h) {
    return {{"side", side_name(h.side)},
            {"asked", {number(h.least_asked), number(h.greatest_asked)}},
            {"least", number(h.least)},
            {"median", number(h.median)},
            {"greatest", number(h.greatest)}};
}

Json untangling(const Untangling& u) {
    return {{"folded_before", u.folded_before},
            {"points_moved", u.points_moved},
            {"largest_move", number(u.largest_move)},
            {"place", point(u.place)},
            {"patches", u.patches},
            {"rounds", u.rounds},
            {"whole_grid", u.whole_grid},
            {"left_at", u.left_at ? point(*u.left_at) : Json(nullptr)}};
}

Json gate(const GateResult& g) {
    return {{"gate", gate_name(g.measure)},
            {"subject", g.subject},
            {"limit", number(g.limit)},
            {"got", number(g.got)},
            {"met", g.met},
            {"where", g.where},
            {"place", g.place ? point(*g.place) : Json(nullptr)},
            {"asked_at", place(g.asked_at)}};
}

Json solve(const SolveMeasure& s) {
    Json history = Json::array();
    for (const double step : s.result.history) history.push_back(number(step));
    Json safeguards = Json::array();
    for (const Safeguard safeguard : s.result.safeguards) {
        safeguards.push_back(safeguard_name(safeguard));
    }
    return {{"name", s.name},
            {"kind", s.is_block ? "block" : "face"},
            {"nodes", extent(s.extent)},
            {"status", status_name(s.result.status)},
            {"cycles", s.result.cycles},
            {"tolerance", number(s.result.tolerance)},
            {"displacement", number(s.result.displacement)},
            {"rate", number(s.result.rate)},
            {"history", history},
            {"safeguards", safeguards},
            {"folded_before", s.result.folded_before},
            {"folded_after", s.result.folded_after},
            {"untangling", s.result.untangling ? untangling(*s.result.untangling) : Json(nullptr)},
            {"flat_at", s.flat_at},
            {"orthogonality",
             s.result.orthogonality ? orthogonality(*s.result.orthogonality) : Json(nullptr)},
            {"heights", list(s.heights, held_heights)},
            {"off_surface", s.off_surface ? Json{{"distance", number(s.off_surface->distance)},
                                                 {"place", point(s.off_surface->place)},
                                                 {"size", number(s.off_surface->size)}}
                                          : Json(nullptr)}};
}

Json angles(const AngleMeasure& a) {
    return {{"corners", a.corners},           {"least", number(a.least)},
            {"greatest", number(a.greatest)}, {"worst_place", point(a.worst_place)},
            {"within_5", a.within_5},         {"within_10", a.within_10}};
}

Json growth(const GrowthMeasure& g) {
    return {{"ratio", number(g.ratio)}, {"place", point(g.place)}};
}

Json wall(const WallMeasure& w) {
    return {{"family", w.family},
            {"nodes", w.nodes},
            {"mean_angle", number(w.mean_angle)},
            {"greatest_angle", number(w.greatest_angle)},
            {"worst_place", point(w.worst_place)},
            {"greatest_angle_beside_ends", number(w.greatest_angle_beside_ends)},
            {"least_height", number(w.least_height)},
            {"median_height", number(w.median_height)},
            {"greatest_height", number(w.greatest_height)}};
}

Json zone(const ZoneMeasure& z) {
    return {{"name", z.name},
            {"nodes", extent(z.extent)},
            {"cells", z.cells},
            {"folded", z.folded},
            {"flat_corners", z.flat_corners},
            {"pole_corners", z.pole_corners},
            {"worst_scaled_jacobian", number(z.worst_scaled_jacobian)},
            {"worst_inside", number(z.worst_inside)},
            {"worst_cell", {z.worst_cell[0] + 1, z.worst_cell[1] + 1, z.worst_cell[2] + 1}},
            {"worst_place", point(z.worst_place)},
            {"angles", angles(z.angles)},
            {"growth", {growth(z.growth[0]), growth(z.growth[1]), growth(z.growth[2])}}};
}

Json spacing(const SpacingMeasure& s) {
    return {{"edge", s.edge},
            {"cells", s.cells},
            {"length", number(s.length)},
            {"first_asked", number(s.asked_start)},
            {"first_got", number(s.got_start)},
            {"last_asked", number(s.asked_end)},
            {"last_got", number(s.got_end)}};
}

Json report_json(const Report& r) {
    return {{"title", r.title},
            {"sound", r.sound()},
            {"cells", r.cells},
            {"nodes", r.nodes},
            {"folded", r.folded()},
            {"worst_scaled_jacobian", number(r.worst_scaled_jacobian())},
            {"angles", angles(r.angles())},
            {"zones", list(r.zones, zone)},
            {"interfaces", list(r.interfaces,
                                [](const InterfaceMeasure& i) {
                                    return Json{{"name", i.name},
                                                {"mismatched", i.mismatched},
                                                {"growth", growth(i.growth)}};
                                })},
            {"walls", list(r.walls, wall)},
            {"spacings", list(r.spacings, spacing)},
            {"solves", list(r.solves, solve)},
            {"put_on_surface", list(r.put_on_surface,
                                    [](const PutMeasure& p) {
                                        return Json{{"what", p.what},
                                                    {"surfaces", p.surfaces},
                                                    {"distance", number(p.distance)},
                                                    {"place", point(p.place)}};
                                    })},
            {"gates", list(r.gates, gate)},
            {"seconds", list(r.stages, [](const StageTime& s) {
                 return Json{{"stage", s.stage}, {"seconds", number(s.seconds)}};
             })}};
}

}  // namespace

std::string to_json(const Outcome& outcome) {
    Json json{
        {"hexweave_json", 1},         {"command", outcome.command},
        {"config", outcome.config},   {"exit_code", outcome.exit_code},
        {"outputs", outcome.outputs}, {"diagnostics", list(outcome.diagnostics.all(), diagnostic)},
        {"failure", outcome.failure}};
    json["report"] = outcome.report ? report_json(*outcome.report) : Json(nullptr);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hexweave
