// SPDX-License-Identifier: Apache-2.0
#include "io/quality_json.h"

#include "io/json_values.h"

namespace hexweave {

namespace {

Json extreme(const CellExtreme& e) {
    return {{"value", json_of(e.value)}, {"cell", json_of(e.cell)}, {"place", json_of(e.place)}};
}

Json bends(const BendMeasure& b) {
    if (b.nodes == 0) return {{"greatest", nullptr}, {"mean", nullptr}, {"place", nullptr}};
    return {{"greatest", json_of(b.greatest)},
            {"mean", json_of(b.mean())},
            {"place", json_of(b.place)}};
}

/// The keys of a run's zone, and more.
Json zone(const ZoneQuality& z) {
    Json json = json_of(z.measure);
    json.update({{"positive", z.positive},
                 {"not_positive", z.not_positive},
                 {"undecided", z.undecided},
                 {"volume", json_of(z.volume)},
                 {"least_volume", extreme(z.least_volume)},
                 {"greatest_volume", extreme(z.greatest_volume)},
                 {"least_jacobian", extreme(z.least_jacobian)},
                 {"greatest_skewness", extreme(z.greatest_skewness)},
                 {"mean_skewness", json_of(z.mean_skewness)},
                 {"skewness_99", json_of(z.skewness_99)},
                 {"greatest_aspect_ratio", extreme(z.greatest_aspect_ratio)},
                 {"bends", json_list(z.bends, bends)}});
    return json;
}

Json interface(const InterfaceQuality& i) {
    return {{"name", i.measure.name},
            {"mismatched", i.measure.mismatched},
            {"growth", json_of(i.measure.growth)},
            {"bends", bends(i.bends)}};
}

Json histogram(const Histogram& h) {
    return {{"measure", h.measure}, {"limits", h.limits}, {"counts", h.counts}};
}

const char* verdict_name(JacobianVerdict verdict) {
    switch (verdict) {
        case JacobianVerdict::positive:
            return "positive";
        case JacobianVerdict::not_positive:
            return "not positive";
        case JacobianVerdict::undecided:
            break;
    }
    return "undecided";
}

Json worst_cell(const WorstCell& w) {
    return {{"zone", w.zone},
            {"cell", json_of(w.cell)},
            {"place", json_of(w.place)},
            {"scaled_jacobian", json_of(w.scaled_jacobian)},
            {"jacobian", verdict_name(w.verdict)},
            {"volume", json_of(w.volume)},
            {"skewness", json_of(w.skewness)}};
}

}  // namespace

std::string to_json(const GridQuality& q, const std::string& grid_file) {
    const Json json{
        {"hexweave_json", 1},
        {"command", "quality"},
        {"grid", grid_file},
        {"title", q.title},
        {"units", q.units},
        {"sound", q.sound()},
        {"cells", q.cells()},
        {"folded", q.folded()},
        {"not_positive", q.not_positive()},
        {"undecided", q.undecided()},
        {"zones", json_list(q.zones, zone)},
        {"interfaces", json_list(q.interfaces, interface)},
        {"boundaries", json_list(q.boundaries, [](const WallMeasure& b) { return json_of(b); })},
        {"histograms", json_list(q.histograms, histogram)},
        {"worst", json_list(q.worst, worst_cell)}};
    return json.dump(2) + "\n";
}

}  // namespace hexweave
