// SPDX-License-Identifier: Apache-2.0
#include "io/comparison_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

namespace hexweave {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json deviation(const Deviation& d) {
    return {{"size", number(d.size)},
            {"node", {d.node[0] + 1, d.node[1] + 1, d.node[2] + 1}},
            {"place", {number(d.place.x), number(d.place.y), number(d.place.z)}}};
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
              {"nodes", {z.extent.ni, z.extent.nj, z.extent.nk}},
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
              {"tolerance", number(c.tolerance)},
              {"floor", number(c.floor)},
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
