// SPDX-License-Identifier: Apache-2.0
#include "topology/read_nets.h"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "geometry/control_mesh.h"
#include "geometry/nurbs.h"
#include "geometry/plot3d_file.h"
#include "topology/read_data_file.h"

namespace hexweave {

namespace {

/// Rows of equal length, one after the other.
template <class Value>
struct Rows {
    int length = 0;
    int count = 0;
    std::vector<Value> values;
};

template <class Value>
using ReadValue = std::optional<Value> (*)(Reading&, const YamlNode&, const std::string&);

/// A list of values, each read by `read`.
template <class Value>
std::optional<std::vector<Value>> read_list(Reading& reading, const YamlNode& node,
                                            const std::string& what, const std::string& item,
                                            ReadValue<Value> read) {
    if (!expect_list(reading, node, what)) return std::nullopt;
    std::vector<Value> values;
    for (const YamlNode& child : node.children) {
        if (auto value = read(reading, child, item)) values.push_back(*std::move(value));
    }
    if (values.size() != node.children.size()) return std::nullopt;
    return values;
}

template <class Value>
std::optional<Rows<Value>> read_rows(Reading& reading, const YamlNode& node,
                                     const std::string& what, const std::string& item,
                                     ReadValue<Value> read) {
    if (!expect_list(reading, node, what)) return std::nullopt;
    Rows<Value> rows;
    bool sound = true;
    for (const YamlNode& child : node.children) {
        const auto row = read_list(reading, child, "a row of " + what, item, read);
        sound = sound && row;
        if (!row) continue;
        const int length = static_cast<int>(row->size());
        if (rows.count++ == 0) rows.length = length;
        if (length != rows.length) {
            reading.diagnostics.error(child.place,
                                      fmt::format("this row of {} has {} items, the first one {}",
                                                  what, length, rows.length),
                                      "all rows have equally many");
            sound = false;
        }
        rows.values.insert(rows.values.end(), row->begin(), row->end());
    }
    return sound ? std::optional(std::move(rows)) : std::nullopt;
}

std::optional<std::vector<double>> read_knots(Reading& reading, const YamlNode& node,
                                              const std::string& what) {
    return read_list<double>(reading, node, what, "a knot", read_number);
}

/// Tells a fault of one part of a net or a polygon; true where there is none.
bool accept(Reading& reading, const YamlNode& node, const std::string& fault) {
    if (!fault.empty()) reading.diagnostics.error(node.place, fault, usage_of(reading, node));
    return fault.empty();
}

/// Whether weights are positive numbers.
bool check_weights(Reading& reading, const YamlNode& node, const std::vector<double>& weights) {
    for (const double weight : weights) {
        if (weight > 0) continue;
        return accept(reading, node, fmt::format("a weight must be positive, not {}", weight));
    }
    return true;
}

struct SurfaceDegrees {
    int u = 1;
    int v = 1;
};

std::optional<SurfaceDegrees> read_degrees(Reading& reading, const YamlNode& node) {
    if (!expect_list(reading, node, "'degree'", 2)) return std::nullopt;
    const auto u = read_count(reading, node.children[0], "the degree along u");
    const auto v = read_count(reading, node.children[1], "the degree along v");
    if (!u || !v) return std::nullopt;
    return SurfaceDegrees{*u, *v};
}

struct SurfaceKnots {
    std::vector<double> u;
    std::vector<double> v;
};

std::optional<SurfaceKnots> read_surface_knots(Reading& reading, const YamlNode& node) {
    if (!expect_mapping(reading, node, "'knots'", "nurbs_knots")) return std::nullopt;
    const YamlNode* along_u = require(reading, node, "u", "'knots'");
    const YamlNode* along_v = require(reading, node, "v", "'knots'");
    if (along_u == nullptr || along_v == nullptr) return std::nullopt;
    auto u = read_knots(reading, *along_u, "the knots of u");
    auto v = read_knots(reading, *along_v, "the knots of v");
    if (!u || !v) return std::nullopt;
    return SurfaceKnots{*std::move(u), *std::move(v)};
}

/// Tells what is wrong with a net at the part that is.
bool check_net(Reading& reading, const YamlNode& node, const NurbsNet& net) {
    const YamlNode& knots = *find(reading, node, "knots");
    const bool points = net.count_u > net.degree_u && net.count_v > net.degree_v;
    const bool degrees =
        net.degree_u <= greatest_nurbs_degree && net.degree_v <= greatest_nurbs_degree;
    if (points && degrees) {
        const bool sound_u = accept(reading, *find(reading, knots, "u"),
                                    knots_fault(net.knots_u, net.degree_u, net.count_u));
        const bool sound_v = accept(reading, *find(reading, knots, "v"),
                                    knots_fault(net.knots_v, net.degree_v, net.count_v));
        if (!sound_u || !sound_v) return false;
    }
    return accept(reading, *find(reading, node, degrees ? "control" : "degree"), fault_of(net));
}

/// The keys that `nurbs` must have.
bool require_parts(Reading& reading, const YamlNode& node) {
    bool all = true;
    for (const std::string_view key : required_keys("nurbs_curve")) {
        all = require(reading, node, key, "'nurbs'") != nullptr && all;
    }
    return all;
}

std::optional<ControlMesh> read_mesh_file(Reading& reading, const YamlNode& node) {
    if (!expect_mapping(reading, node, "'control_points'", "point_rows_file")) return std::nullopt;
    const YamlNode* name = require(reading, node, "file", "'control_points'");
    if (name == nullptr) return std::nullopt;
    const auto file = read_data_file(reading, *name, "'file'");
    const YamlNode* which = find(reading, node, "block");
    std::optional<int> block;
    if (which != nullptr) block = read_count(reading, *which, "'block'");
    if (!file || (which != nullptr && !block)) return std::nullopt;
    Plot3dSurface surface = read_plot3d_surface(file->text, block);
    if (surface.error.empty()) return std::move(surface.mesh);
    tell_file_fault(reading, *name, file, surface.error, surface.line,
                    "it must be a Plot3D text file: the counts ni nj 1, all x, all y, all z; "
                    "'block' says which of several");
    return std::nullopt;
}

std::optional<ControlMesh> read_mesh(Reading& reading, const YamlNode& node) {
    if (node.is_mapping()) return read_mesh_file(reading, node);
    auto rows = read_rows<Vec3>(reading, node, "'control_points'", "a point", read_point);
    if (!rows) return std::nullopt;
    return ControlMesh{rows->length, rows->count, std::move(rows->values)};
}

}  // namespace

std::optional<Curve> read_nurbs_curve(Reading& reading, const YamlNode& entry) {
    const YamlNode& node = *entry.find("nurbs");
    if (!expect_mapping(reading, node, "'nurbs'", "nurbs_curve")) return std::nullopt;
    if (!require_parts(reading, node)) return std::nullopt;
    const YamlNode& knots = *find(reading, node, "knots");
    const YamlNode& control = *find(reading, node, "control");
    const YamlNode* given = find(reading, node, "weights");
    const auto degree = read_count(reading, *find(reading, node, "degree"), "'degree'");
    auto row = read_knots(reading, knots, "'knots'");
    auto points = read_list<Vec3>(reading, control, "'control'", "a control point", read_point);
    std::optional<std::vector<double>> weights = std::vector<double>();
    if (given != nullptr) {
        weights = read_list<double>(reading, *given, "'weights'", "a weight", read_number);
    }
    if (!degree || !row || !points || !weights) return std::nullopt;
    if (!check_weights(reading, given == nullptr ? node : *given, *weights)) return std::nullopt;
    NurbsPolygon polygon{*degree, *std::move(row), *std::move(points), *std::move(weights)};
    const int count = static_cast<int>(polygon.control.size());
    if (count > *degree && *degree <= greatest_nurbs_degree &&
        !accept(reading, knots, knots_fault(polygon.knots, *degree, count))) {
        return std::nullopt;
    }
    if (!accept(reading, *degree > greatest_nurbs_degree ? *find(reading, node, "degree") : control,
                fault_of(polygon))) {
        return std::nullopt;
    }
    return nurbs_curve(std::move(polygon));
}

std::optional<Surface> read_nurbs_surface(Reading& reading, const YamlNode& entry) {
    const YamlNode& node = *find(reading, entry, "nurbs");
    if (!expect_mapping(reading, node, "'nurbs'", "nurbs_surface")) return std::nullopt;
    if (!require_parts(reading, node)) return std::nullopt;
    const auto degrees = read_degrees(reading, *find(reading, node, "degree"));
    auto knots = read_surface_knots(reading, *find(reading, node, "knots"));
    auto control = read_rows<Vec3>(reading, *find(reading, node, "control"), "'control'",
                                   "a control point", read_point);
    const YamlNode* given = find(reading, node, "weights");
    std::optional<Rows<double>> weights = Rows<double>();
    if (given != nullptr) {
        weights = read_rows<double>(reading, *given, "'weights'", "a weight", read_number);
    }
    if (!degrees || !knots || !control || !weights) return std::nullopt;
    if (given != nullptr &&
        (weights->length != control->length || weights->count != control->count)) {
        accept(reading, *given,
               fmt::format("there are {} rows of {} weights for {} rows of {} control points",
                           weights->count, weights->length, control->count, control->length));
        return std::nullopt;
    }
    if (!check_weights(reading, given == nullptr ? node : *given, weights->values)) {
        return std::nullopt;
    }
    NurbsNet net{degrees->u,
                 degrees->v,
                 control->length,
                 control->count,
                 std::move(knots->u),
                 std::move(knots->v),
                 std::move(control->values),
                 std::move(weights->values)};
    if (!check_net(reading, node, net)) return std::nullopt;
    return nurbs_surface(std::move(net));
}

std::optional<Surface> read_control_points(Reading& reading, const YamlNode& entry) {
    const YamlNode& node = *find(reading, entry, "control_points");
    const auto mesh = read_mesh(reading, node);
    if (!mesh || !accept(reading, node, fault_of(*mesh))) return std::nullopt;
    return control_surface(*mesh);
}

}  // namespace hexweave
