// SPDX-License-Identifier: Apache-2.0
#include "io/quality_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace hexweave {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}
Json point(const Vec3& p) {
    return {number(p.x), number(p.y), number(p.z)};
}
Json cell(const Node& n) {
    return {n[0] + 1, n[1] + 1, n[2] + 1};
}

template <class Items, class Convert>
Json list(const Items& items, Convert convert) {
    Json array = Json::array();
    for (const auto& item : items) array.push_back(convert(item));
    return array;
}

Json extreme(const CellExtreme& e) {
    return {{"value", number(e.value)}, {"cell", cell(e.cell)}, {"place", point(e.place)}};
}

Json bends(const BendMeasure& b) {
    return {
        {"greatest", number(b.greatest)}, {"mean", number(b.mean())}, {"place", point(b.place)}};
}

Json growth(const GrowthMeasure& g) {
    return {{"ratio", number(g.ratio)}, {"place", point(g.place)}};
}

Json angles(const AngleMeasure& a) {
    return {{"corners", a.corners},           {"least", number(a.least)},
            {"greatest", number(a.greatest)}, {"worst_place", point(a.worst_place)},
            {"within_5", a.within_5},         {"within_10", a.within_10}};
}

Json zone(const ZoneQuality& z) {
    const ZoneMeasure& m = z.measure;
    return {{"name", m.name},
            {"nodes", {m.extent.ni, m.extent.nj, m.extent.nk}},
            {"cells", m.cells},
            {"folded", m.folded},
            {"flat_corners", m.flat_corners},
            {"worst_scaled_jacobian", number(m.worst_scaled_jacobian)},
            {"worst_inside", number(m.worst_inside)},
            {"positive", z.positive},
            {"not_positive", z.not_positive},
            {"undecided", z.undecided},
            {"volume", number(z.volume)},
            {"least_volume", extreme(z.least_volume)},
            {"greatest_volume", extreme(z.greatest_volume)},
            {"least_jacobian", extreme(z.least_jacobian)},
            {"angles", angles(m.angles)},
            {"greatest_skewness", extreme(z.greatest_skewness)},
            {"mean_skewness", number(z.mean_skewness)},
            {"greatest_aspect_ratio", extreme(z.greatest_aspect_ratio)},
            {"growth", list(m.growth, growth)},
            {"bends", list(z.bends, bends)}};
}

Json interface(const InterfaceQuality& i) {
    return {{"name", i.measure.name},
            {"mismatched", i.measure.mismatched},
            {"growth", growth(i.measure.growth)},
            {"bends", bends(i.bends)}};
}

Json boundary(const WallMeasure& b) {
    return {{"family", b.family},
            {"nodes", b.nodes},
            {"mean_angle", number(b.mean_angle)},
            {"greatest_angle", number(b.greatest_angle)},
            {"worst_place", point(b.worst_place)},
            {"greatest_angle_beside_ends", number(b.greatest_angle_beside_ends)},
            {"least_height", number(b.least_height)},
            {"median_height", number(b.median_height)},
            {"greatest_height", number(b.greatest_height)}};
}

Json histogram(const Histogram& h) {
    return {{"measure", h.measure}, {"limits", h.limits}, {"counts", h.counts}};
}

Json worst_cell(const WorstCell& w) {
    return {{"zone", w.zone},
            {"cell", cell(w.cell)},
            {"place", point(w.place)},
            {"scaled_jacobian", number(w.scaled_jacobian)},
            {"volume", number(w.volume)},
            {"skewness", number(w.skewness)}};
}

}  // namespace

std::string to_json(const GridQuality& q, const std::string& grid_file) {
    const Json json{{"hexweave_json", 1},
                    {"command", "quality"},
                    {"grid", grid_file},
                    {"title", q.title},
                    {"units", q.units},
                    {"sound", q.sound()},
                    {"cells", q.cells()},
                    {"folded", q.folded()},
                    {"not_positive", q.not_positive()},
                    {"undecided", q.undecided()},
                    {"zones", list(q.zones, zone)},
                    {"interfaces", list(q.interfaces, interface)},
                    {"boundaries", list(q.boundaries, boundary)},
                    {"histograms", list(q.histograms, histogram)},
                    {"worst", list(q.worst, worst_cell)}};
    return json.dump(2) + "\n";
}

}  // namespace hexweave
