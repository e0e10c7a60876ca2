// SPDX-License-Identifier: Apache-2.0
#include "io/report_json.h"

#include "io/json_values.h"
#include "io/remarks.h"

namespace hexweave {
namespace {

Json place(const Place& p) {
    return {{"file", p.file ? p.file->name : ""}, {"line", p.line}, {"column", p.column}};
}

Json diagnostic(const Diagnostic& d) {
    Json notes = Json::array();
    for (const Note& n : all_notes(d)) {
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

Json first_heights(const HeightMeasure& h) {
    return {{"side", side_name(h.side)},
            {"held", h.held},
            {"asked", {json_of(h.least_asked), json_of(h.greatest_asked)}},
            {"least", json_of(h.least)},
            {"median", json_of(h.median)},
            {"greatest", json_of(h.greatest)},
            {"stopped",
             {{"growth", h.stopped.growth}, {"fade", h.stopped.fade}, {"folds", h.stopped.folds}}},
            {"ends_amiss", h.ends_amiss}};
}

Json untangling(const Untangling& u) {
    return {{"folded_before", u.folded_before},
            {"points_moved", u.points_moved},
            {"largest_move", json_of(u.largest_move)},
            {"place", json_of(u.place)},
            {"patches", u.patches},
            {"rounds", u.rounds},
            {"whole_grid", u.whole_grid},
            {"left_at", json_of(u.left_at)}};
}

Json gate(const GateResult& g) {
    return {{"gate", gate_name(g.measure)},
            {"subject", g.subject},
            {"limit", json_of(g.limit)},
            {"got", g.judged ? json_of(g.got) : Json(nullptr)},
            {"met", g.met},
            {"where", g.where},
            {"place", json_of(g.place)},
            {"asked_at", place(g.asked_at)}};
}

Json solve(const SolveMeasure& s) {
    Json history = Json::array();
    for (const double step : s.result.history) history.push_back(json_of(step));
    Json safeguards = Json::array();
    for (const Safeguard safeguard : s.result.safeguards) {
        safeguards.push_back(safeguard_name(safeguard));
    }
    return {{"name", s.name},
            {"kind", s.is_block ? "block" : "face"},
            {"nodes", json_of(s.extent)},
            {"status", status_name(s.result.status)},
            {"cycles", s.result.cycles},
            {"tolerance", json_of(s.result.tolerance)},
            {"displacement", json_of(s.result.displacement)},
            {"rate", json_of(s.result.rate)},
            {"history", history},
            {"safeguards", safeguards},
            {"kept_cycle", s.result.kept_cycle ? Json(*s.result.kept_cycle) : Json(nullptr)},
            {"folded_before", s.result.folded_before},
            {"folded_after", s.result.folded_after},
            {"untangling", s.result.untangling ? untangling(*s.result.untangling) : Json(nullptr)},
            {"flat_at", s.flat_at},
            {"orthogonality",
             s.result.orthogonality ? orthogonality(*s.result.orthogonality) : Json(nullptr)},
            {"heights", json_list(s.heights, first_heights)},
            {"off_surface", s.off_surface ? Json{{"distance", json_of(s.off_surface->distance)},
                                                 {"place", json_of(s.off_surface->place)},
                                                 {"size", json_of(s.off_surface->size)}}
                                          : Json(nullptr)}};
}

Json spacing(const SpacingMeasure& s) {
    return {{"edge", s.edge},
            {"cells", s.cells},
            {"length", json_of(s.length)},
            {"first_asked", json_of(s.asked_start)},
            {"first_got", json_of(s.got_start)},
            {"last_asked", json_of(s.asked_end)},
            {"last_got", json_of(s.got_end)},
            {"first", json_of(s.first)},
            {"last", json_of(s.last)}};
}

Json adjusted_count(const AdjustedCount& a) {
    return {{"edge", a.edge}, {"written", a.written}, {"asked", json_of(a.asked)}, {"got", a.got}};
}

Json planned(const PlannedGrid& g) {
    return {
        {"level", g.level},     {"cells", g.cells},
        {"nodes", g.nodes},     {"memory", json_of(g.memory)},
        {"threads", g.threads}, {"adjusted_counts", json_list(g.adjusted_counts, adjusted_count)}};
}

Json level(const LevelMeasure& l) {
    return {{"name", l.name},
            {"factor", json_of(l.factor)},
            {"names", l.names},
            {"solved", l.solved},
            {"stride", l.stride}};
}

Json offender(const OffenderFile& o) {
    return {{"name", o.name}, {"kind", o.is_block ? "block" : "face"}, {"file", o.path}};
}

Json parameter(const Parameter& p) {
    return {{"name", p.name.value}, {"value", json_of(p.value)}, {"overridden", p.overridden}};
}

Json report_json(const Report& r) {
    return {{"title", r.title},
            {"level", r.level ? level(*r.level) : Json(nullptr)},
            {"sound", r.sound()},
            {"cells", r.cells},
            {"nodes", r.nodes},
            {"folded", r.folded()},
            {"worst_scaled_jacobian", json_of(r.worst_scaled_jacobian())},
            {"angles", json_of(r.angles())},
            {"zones", json_list(r.zones, [](const ZoneMeasure& z) { return json_of(z); })},
            {"interfaces", json_list(r.interfaces,
                                     [](const InterfaceMeasure& i) {
                                         return Json{{"name", i.name},
                                                     {"periodic", i.periodic},
                                                     {"mismatched", i.mismatched},
                                                     {"bend", json_of(i.bend)},
                                                     {"bend_place", json_of(i.bend_place)},
                                                     {"growth", json_of(i.growth)}};
                                     })},
            {"walls", json_list(r.walls, [](const WallMeasure& w) { return json_of(w); })},
            {"spacings", json_list(r.spacings, spacing)},
            {"solves", json_list(r.solves, solve)},
            {"put_on_surface", json_list(r.put_on_surface,
                                         [](const PutMeasure& p) {
                                             return Json{{"what", p.what},
                                                         {"surfaces", p.surfaces},
                                                         {"distance", json_of(p.distance)},
                                                         {"place", json_of(p.place)}};
                                         })},
            {"gates", json_list(r.gates, gate)},
            {"remarks", json_list(remarks(r),
                                  [](const Remark& remark) {
                                      return Json{
                                          {"severity", remark.is_warning ? "warning" : "note"},
                                          {"message", remark.message},
                                          {"hint", remark.hint}};
                                  })},
            {"seconds", json_list(r.stages, [](const StageTime& s) {
                 return Json{{"stage", s.stage}, {"seconds", json_of(s.seconds)}};
             })}};
}

}  // namespace

std::string to_json(const Outcome& outcome) {
    Json json{{"hexweave_json", 1},
              {"command", outcome.command},
              {"config", outcome.config},
              {"exit_code", outcome.exit_code},
              {"outputs", outcome.outputs},
              {"offenders", json_list(outcome.offenders, offender)},
              {"diagnostics", json_list(outcome.diagnostics.all(), diagnostic)},
              {"failure", outcome.failure},
              {"parameters", json_list(outcome.parameters, parameter)},
              {"grids", json_list(outcome.grids, planned)}};
    json["report"] = outcome.report ? report_json(*outcome.report) : Json(nullptr);
    json["levels"] = json_list(outcome.levels, report_json);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hexweave
