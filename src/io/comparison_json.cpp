// SPDX-License-Identifier: Apache-2.0
#include "io/comparison_json.h"

#include <vector>

#include "io/json_values.h"

namespace hexweave {
namespace {

Json deviation(const Deviation& d) {
    return {{"size", json_of(d.size)}, {"node", json_of(d.node)}, {"place", json_of(d.place)}};
}

Json points(const ZoneDeviation& d) {
    return {{"points", d.points},
            {"beyond", d.beyond},
            {"not_finite", d.not_finite},
            {"in_cells", deviation(d.in_cells)},
            {"in_length", deviation(d.in_length)}};
}

Json zone(const ZoneComparison& z) {
    Json json{{"name", z.name},
              {"golden", z.golden_name},
              {"nodes", json_of(z.extent)},
              {"axes", z.to_golden.axes}};
    json.update(points(z.deviation));
    return json;
}

Json others(const std::vector<OtherNodes>& list) {
    Json json = Json::array();
    for (const OtherNodes& kind : list) {
        json.push_back({{"kind", kind.kind}, {"first", kind.first}, {"count", kind.count}});
    }
    return json;
}

Json comparison_json(const GridComparison& c) {
    Json zones = Json::array();
    for (const ZoneComparison& z : c.zones) zones.push_back(zone(z));
    Json differences = Json::array();
    for (const Difference& d : c.differences) {
        differences.push_back({{"kind", d.kind}, {"text", d.text}});
    }
    Json json{{"same", c.same()},
              {"tolerance", json_of(c.tolerance)},
              {"floor", json_of(c.floor)},
              {"units", c.units}};
    json.update(points(c.all()));
    json["zones"] = zones;
    json["differences"] = differences;
    json["not_compared"] = others(c.others);
    json["not_compared_in_golden"] = others(c.golden_others);
    return json;
}

}  // namespace

std::string to_json(const ComparisonOutcome& outcome) {
    Json json{
        {"hexweave_json", 1},       {"command", "compare"},           {"new", outcome.candidate},
        {"golden", outcome.golden}, {"exit_code", outcome.exit_code}, {"failure", outcome.failure}};
    json["comparison"] = outcome.comparison ? comparison_json(*outcome.comparison) : Json(nullptr);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hexweave
