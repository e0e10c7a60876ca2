// SPDX-License-Identifier: Apache-2.0
#include "io/geometry_text.h"
#include "io/json_values.h"

namespace hexweave {
namespace {

Json box(const CadBox& b) {
    return {{"low", json_of(b.low)}, {"high", json_of(b.high)}};
}

Json curve(const CadCurve& c) {
    Json json{{"type", c.type}, {"fault", c.fault}, {"box", box(c.box)}};
    if (!c.fault.empty()) return json;
    const Curve shape = cad_curve(c, 1);
    json["degree"] = c.polygon.degree;
    json["points"] = c.polygon.control.size();
    json["range"] = {shape.begin, shape.end};
    json["start"] = json_of(evaluate(shape, shape.begin));
    json["end"] = json_of(evaluate(shape, shape.end));
    return json;
}

Json curves(const std::vector<CadCurve>& list) {
    Json json = Json::array();
    for (const CadCurve& c : list) json.push_back(curve(c));
    return json;
}

Json face(const CadFace& f) {
    Json json{{"type", f.type}, {"fault", f.fault}};
    if (f.fault.empty()) {
        json["degree"] = {f.net.degree_u, f.net.degree_v};
        json["points"] = {f.net.count_u, f.net.count_v};
        json["u"] = f.range_u;
        json["v"] = f.range_v;
        json["trimmed"] = f.trimmed;
        json["box"] = box(f.box);
    }
    json["edges"] = curves(f.edges);
    return json;
}

Json entity(const CadEntity& e) {
    Json json{{"number", e.number}, {"type", e.type}, {"label", e.label}, {"name", e.name}};
    json["faces"] = Json::array();
    for (const CadFace& f : e.faces) json["faces"].push_back(face(f));
    json["curves"] = curves(e.curves);
    return json;
}

}  // namespace

std::string to_json(const CadFile& file, const std::string& name) {
    Json json{{"hexweave_json", 1},
              {"command", "geometry"},
              {"file", name},
              {"format", file.format == CadFormat::iges ? "IGES" : "STEP"},
              {"unit", file.unit},
              {"unit_in_metres", file.unit.empty() ? Json(nullptr) : Json(file.unit_in_metres)},
              {"several_units", file.several_units}};
    json["entities"] = Json::array();
    for (const CadEntity& e : file.entities) json["entities"].push_back(entity(e));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hexweave
