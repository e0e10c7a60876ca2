// SPDX-License-Identifier: Apache-2.0
#include "topology/read_surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/lines.h"
#include "geometry/surface.h"
#include "geometry/surface_parts.h"
#include "topology/read_cad.h"
#include "topology/read_family.h"
#include "topology/read_nets.h"
#include "topology/read_surface_parameters.h"
#include "topology/read_transforms.h"

namespace hexweave {

namespace {

using MaybeSurface = std::optional<Surface>;

struct SurfaceFamily {
    std::string_view key;
    MaybeSurface (*read)(Reading& reading, const YamlNode& entry, Shapes& shapes);
};

/// A vector that must not be zero.
std::optional<Vec3> read_direction(Reading& reading, const YamlNode& mapping, std::string_view key,
                                   const std::string& of) {
    const YamlNode* node = require(reading, mapping, key, of);
    if (node == nullptr) return std::nullopt;
    const auto direction = read_point(reading, *node, fmt::format("'{}'", key));
    if (!direction || norm(*direction) > 0) return direction;
    reading.diagnostics.error(node->place, fmt::format("'{}' must not be zero", key),
                              usage_of(reading, *node));
    return std::nullopt;
}

std::optional<Vec3> require_point(Reading& reading, const YamlNode& mapping, std::string_view key,
                                  const std::string& of) {
    const YamlNode* node = require(reading, mapping, key, of);
    return node == nullptr ? std::nullopt : read_point(reading, *node, fmt::format("'{}'", key));
}

std::optional<std::array<double, 2>> require_range(Reading& reading, const YamlNode& entry,
                                                   std::string_view key) {
    const YamlNode* node = require(reading, entry, key, fmt::format("surface '{}'", entry.key));
    const std::string what = fmt::format("'{}'", key);
    if (node == nullptr || !expect_list(reading, *node, what, 2)) return std::nullopt;
    const auto begin = read_number(reading, node->children[0], "the begin of " + what);
    const auto end = read_number(reading, node->children[1], "the end of " + what);
    if (!begin || !end) return std::nullopt;
    if (*begin < *end) return std::array{*begin, *end};
    reading.diagnostics.error(
        node->place, fmt::format("{} must ascend, not run from {} to {}", what, *begin, *end),
        fmt::format("write [{}, {}]; 'reverse: {}' runs it backwards", *end, *begin, key));
    return std::nullopt;
}

using FormulaOfTwo = std::function<double(double, double)>;

/// Where a formula is not finite, found on a fine net of its ranges; tells it.
bool check_finite(Reading& reading, const YamlNode& node, const FormulaOfTwo& formula,
                  const std::array<double, 2>& range_u, const std::array<double, 2>& range_v) {
    constexpr int samples = 32;
    for (int j = 0; j <= samples; ++j) {
        for (int i = 0; i <= samples; ++i) {
            const double u = range_u[0] + (range_u[1] - range_u[0]) * i / samples;
            const double v = range_v[0] + (range_v[1] - range_v[0]) * j / samples;
            if (std::isfinite(formula(u, v))) continue;
            reading.diagnostics.error(
                node.place,
                fmt::format("'{}' is not finite at u = {}, v = {}", shown(node.text), u, v),
                "change the formula, or take that place out of the ranges");
            return false;
        }
    }
    return true;
}

MaybeSurface read_formula_surface(Reading& reading, const YamlNode& entry, Shapes&) {
    const YamlNode& node = *find(reading, entry, "formula");
    const auto range_u = require_range(reading, entry, "u");
    const auto range_v = require_range(reading, entry, "v");
    if (!node.is_sequence() || node.children.size() != 3) {
        reading.diagnostics.error(node.place,
                                  "'formula' must be a list of three formulas of u and v",
                                  "write [x, y, z], as in [u, v, u * v]");
        return std::nullopt;
    }
    std::array<FormulaOfTwo, 3> parts;
    bool sound = true;
    for (std::size_t n = 0; n < 3; ++n) {
        auto part = read_formula_of_uv(reading, node.children[n], "a part of 'formula'");
        sound = sound && part;
        if (part) parts.at(n) = std::move(*part);
    }
    if (!sound || !range_u || !range_v) return std::nullopt;
    for (std::size_t n = 0; n < 3; ++n) {
        sound = check_finite(reading, node.children[n], parts.at(n), *range_u, *range_v) && sound;
    }
    if (!sound) return std::nullopt;
    const auto position = [parts](double u, double v) {
        return Vec3{parts[0](u, v), parts[1](u, v), parts[2](u, v)};
    };
    return formula_surface(position, *range_u, *range_v);
}

MaybeSurface read_plane_surface(Reading& reading, const YamlNode& entry, Shapes&) {
    const YamlNode& node = *find(reading, entry, "plane");
    if (!expect_mapping(reading, node, "'plane'", "plane")) return std::nullopt;
    const auto point = require_point(reading, node, "point", "'plane'");
    const auto u = read_direction(reading, node, "u", "'plane'");
    const auto v = read_direction(reading, node, "v", "'plane'");
    if (!point || !u || !v) return std::nullopt;
    return plane_surface(*point, *u, *v);
}

MaybeSurface read_sphere(Reading& reading, const YamlNode& entry, Shapes&) {
    const YamlNode& node = *find(reading, entry, "sphere");
    if (!expect_mapping(reading, node, "'sphere'", "sphere")) return {};
    const auto center = require_point(reading, node, "center", "'sphere'");
    const YamlNode* length = require(reading, node, "radius", "'sphere'");
    const auto radius =
        length == nullptr ? std::nullopt : read_positive(reading, *length, "'radius'");
    std::optional<Vec3> axis = Vec3{0, 0, 1};
    if (find(reading, node, "axis") != nullptr) {
        axis = read_direction(reading, node, "axis", "'sphere'");
    }
    if (!center || !radius || !axis) return std::nullopt;
    return sphere(*center, *radius, *axis);
}

/// The ends of the axis of a cylinder or cone.
std::optional<std::array<Vec3, 2>> read_axis_ends(Reading& reading, const YamlNode& node,
                                                  const std::string& of) {
    const auto from = require_point(reading, node, "from", of);
    const auto to = require_point(reading, node, "to", of);
    if (!from || !to) return std::nullopt;
    if (!(*from == *to)) return std::array{*from, *to};
    reading.diagnostics.error(find(reading, node, "to")->place, "'from' and 'to' are the same",
                              "they are the two ends of the axis");
    return std::nullopt;
}

MaybeSurface read_cylinder(Reading& reading, const YamlNode& entry, Shapes&) {
    const YamlNode& node = *find(reading, entry, "cylinder");
    if (!expect_mapping(reading, node, "'cylinder'", "cylinder")) return {};
    const auto ends = read_axis_ends(reading, node, "'cylinder'");
    const YamlNode* length = require(reading, node, "radius", "'cylinder'");
    const auto radius =
        length == nullptr ? std::nullopt : read_positive(reading, *length, "'radius'");
    if (!ends || !radius) return std::nullopt;
    return cone((*ends)[0], (*ends)[1], *radius, *radius);
}

MaybeSurface read_cone(Reading& reading, const YamlNode& entry, Shapes&) {
    const YamlNode& node = *find(reading, entry, "cone");
    if (!expect_mapping(reading, node, "'cone'", "cone")) return std::nullopt;
    const auto ends = read_axis_ends(reading, node, "'cone'");
    const YamlNode* radii = require(reading, node, "radii", "'cone'");
    if (radii == nullptr || !expect_list(reading, *radii, "'radii'", 2)) return std::nullopt;
    const auto first = read_number(reading, radii->children[0], "a radius");
    const auto second = read_number(reading, radii->children[1], "a radius");
    if (!ends || !first || !second) return std::nullopt;
    if (*first >= 0 && *second >= 0) return cone((*ends)[0], (*ends)[1], *first, *second);
    reading.diagnostics.error(radii->place, "a radius must not be negative",
                              "0 is the tip of the cone");
    return std::nullopt;
}

MaybeSurface read_ruled(Reading& reading, const YamlNode& entry, Shapes& shapes) {
    const YamlNode& node = *find(reading, entry, "ruled");
    if (!expect_list(reading, node, "'ruled'", 2)) return std::nullopt;
    const auto first = use_curve(shapes, node.children[0], "a curve of 'ruled'");
    const auto second = use_curve(shapes, node.children[1], "a curve of 'ruled'");
    if (!first || !second) return std::nullopt;
    return ruled_surface(*first, *second);
}

MaybeSurface read_revolution(Reading& reading, const YamlNode& entry, Shapes& shapes) {
    const YamlNode& node = *find(reading, entry, "revolution");
    if (!expect_mapping(reading, node, "'revolution'", "revolution")) return std::nullopt;
    const YamlNode* name = require(reading, node, "curve", "'revolution'");
    const auto curve = name == nullptr ? nullptr : use_curve(shapes, *name, "'curve'");
    const auto axis = read_direction(reading, node, "axis", "'revolution'");
    std::optional<Vec3> center = Vec3{};
    if (const YamlNode* given = find(reading, node, "center")) {
        center = read_point(reading, *given, "'center'");
    }
    constexpr double full_turn = 2 * std::numbers::pi;
    std::optional<double> turn = full_turn;
    if (const YamlNode* given = find(reading, node, "angle")) {
        turn = read_positive(reading, *given, "'angle'");
        if (turn && *turn > full_turn * (1 + 1e-12)) {
            reading.diagnostics.error(given->place,
                                      "a curve can be turned at most once round, by 2 * pi",
                                      "angles are in radians: 90 degrees are pi / 2");
            return std::nullopt;
        }
    }
    if (!curve || !axis || !center || !turn) return std::nullopt;
    return revolution(*curve, *center, *axis, *turn);
}

MaybeSurface read_extrusion(Reading& reading, const YamlNode& entry, Shapes& shapes) {
    const YamlNode& node = *find(reading, entry, "extrusion");
    if (!expect_mapping(reading, node, "'extrusion'", "extrusion")) return std::nullopt;
    const YamlNode* name = require(reading, node, "curve", "'extrusion'");
    const YamlNode* way = require(reading, node, "along", "'extrusion'");
    const auto curve = name == nullptr ? nullptr : use_curve(shapes, *name, "'curve'");
    if (way == nullptr) return std::nullopt;
    if (!way->is_sequence()) {
        const auto path = use_curve(shapes, *way, "'along'");
        return curve && path ? MaybeSurface(extrusion(*curve, *path)) : std::nullopt;
    }
    const auto vector = read_direction(reading, node, "along", "'extrusion'");
    if (!curve || !vector) return std::nullopt;
    return extrusion(*curve, straight_line({}, *vector));
}

MaybeSurface read_other_surface(Reading& reading, const YamlNode& entry, Shapes& shapes) {
    const auto other = use_surface(shapes, *find(reading, entry, "of"), "'of'");
    return other ? MaybeSurface(*other) : std::nullopt;
}

const std::vector<SurfaceFamily>& surface_families() {
    static const std::vector<SurfaceFamily> list{
        {"formula", read_formula_surface},
        {"plane", read_plane_surface},
        {"sphere", read_sphere},
        {"cylinder", read_cylinder},
        {"cone", read_cone},
        {"ruled", read_ruled},
        {"revolution", read_revolution},
        {"extrusion", read_extrusion},
        {"nurbs", [](Reading& r, const YamlNode& e, Shapes&) { return read_nurbs_surface(r, e); }},
        {"control_points",
         [](Reading& r, const YamlNode& e, Shapes&) { return read_control_points(r, e); }},
        {"cad", [](Reading& r, const YamlNode& e, Shapes&) { return read_cad_surface(r, e); }},
        {"of", read_other_surface},
    };
    return list;
}

/// Whether some part of the surface has a normal.
bool has_area(const Surface& surface) {
    constexpr int samples = 8;
    for (int j = 0; j < samples; ++j) {
        for (int i = 0; i < samples; ++i) {
            const auto at = [](const std::array<double, 2>& range, int n) {
                return range[0] + (range[1] - range[0]) * (n + 0.5) / samples;
            };
            const double u = at(surface.range_u, i);
            const double v = at(surface.range_v, j);
            const Vec3 along_u = surface.derivative_u(u, v);
            const Vec3 along_v = surface.derivative_v(u, v);
            if (norm(cross(along_u, along_v)) > 1e-9 * norm(along_u) * norm(along_v)) return true;
        }
    }
    return false;
}

}  // namespace

std::shared_ptr<const Surface> read_surface(Shapes& shapes, const YamlNode& entry) {
    Reading& reading = shapes.reading;
    const std::string what = fmt::format("surface '{}'", shown(entry.key));
    static const Keys names = [] {
        Keys list;
        for (const SurfaceFamily& family : surface_families()) list.push_back(family.key);
        return list;
    }();
    const std::string key = read_family(reading, entry, what, names);
    if (key.empty()) return nullptr;
    const SurfaceFamily& family =
        *std::find_if(surface_families().begin(), surface_families().end(),
                      [&](const SurfaceFamily& f) { return f.key == key; });
    expect_mapping(reading, entry, what, FormatNames("surface_" + key));

    MaybeSurface shape = family.read(reading, entry, shapes);
    if (shape) shape = with_parameters(reading, entry, *shape);
    const std::optional<std::vector<Affine>> maps = read_transforms(reading, entry, what);
    if (!shape || !maps || has_misspelled(reading, entry)) return nullptr;
    Affine whole;
    for (const Affine& map : *maps) whole = compose(whole, map);
    if (!maps->empty()) shape = transformed(*shape, whole);
    if (has_area(*shape)) return std::make_shared<const Surface>(std::move(*shape));
    reading.diagnostics.error(entry.key_place, fmt::format("{} has no area", what),
                              "its two parameters lead in the same direction everywhere");
    return nullptr;
}

}  // namespace hexweave
