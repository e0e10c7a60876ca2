// SPDX-License-Identifier: Apache-2.0
#include "topology/read_shapes.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "geometry/airfoil.h"
#include "geometry/conics.h"
#include "geometry/formula.h"
#include "geometry/lines.h"
#include "geometry/naca.h"
#include "geometry/spline.h"
#include "topology/read_cad.h"
#include "topology/read_data_file.h"
#include "topology/read_nets.h"

namespace hexweave {

namespace {

/// A maker's curve, or its fault told at the node that holds the data.
MaybeCurve accept(Reading& reading, const YamlNode& node, CurveResult result) {
    if (!result.curve) {
        reading.diagnostics.error(node.place, result.error, usage_of(reading, node));
    }
    return std::move(result.curve);
}

MaybeCurve read_line(Reading& reading, const YamlNode& node) {
    if (!expect_list(reading, node, "'line'", 2)) return std::nullopt;
    const auto points = read_points(reading, node, "'line'");
    if (!points) return std::nullopt;
    if (!((*points)[0] == (*points)[1])) return straight_line((*points)[0], (*points)[1]);
    reading.diagnostics.error(node.place, "the two points of this line are the same",
                              "a line is drawn between two different points");
    return std::nullopt;
}

MaybeCurve read_polyline(Reading& reading, const YamlNode& node) {
    const auto points = read_points(reading, node, "'polyline'");
    return points ? accept(reading, node, polyline(*points)) : std::nullopt;
}

MaybeCurve read_spline(Reading& reading, const YamlNode& node) {
    const auto points = read_points(reading, node, "'spline'");
    return points ? accept(reading, node, spline(*points)) : std::nullopt;
}

/// The plane of a circle, arc or ellipse: its `normal`, or z.
std::optional<PlaneAxes> read_plane(Reading& reading, const YamlNode& node) {
    const YamlNode* normal = find(reading, node, "normal");
    if (normal == nullptr) return PlaneAxes{};
    const auto direction = read_point(reading, *normal, "'normal'");
    if (!direction) return std::nullopt;
    const auto axes = plane_axes(*direction);
    if (!axes) {
        reading.diagnostics.error(normal->place, "'normal' must not be zero",
                                  usage_of(reading, *normal));
    }
    return axes;
}

/// The values of required keys that are numbers or points.
template <class Value, class Reader>
std::optional<Value> read_required(Reading& reading, const YamlNode& node, std::string_view key,
                                   const std::string& what, Reader read) {
    const YamlNode* value = require(reading, node, key, what);
    return value == nullptr ? std::nullopt : read(reading, *value, fmt::format("'{}'", key));
}

MaybeCurve read_circle(Reading& reading, const YamlNode& node) {
    if (!expect_mapping(reading, node, "'circle'", "circle")) return {};
    const auto center = read_required<Vec3>(reading, node, "center", "'circle'", read_point);
    const auto radius = read_required<double>(reading, node, "radius", "'circle'", read_positive);
    const auto axes = read_plane(reading, node);
    if (!center || !radius || !axes) return std::nullopt;
    return circle(*center, *radius, *axes);
}

MaybeCurve read_arc_through(Reading& reading, const YamlNode& node) {
    if (!expect_mapping(reading, node, "'arc' with 'through'", "arc_through")) return std::nullopt;
    const YamlNode& through = *find(reading, node, "through");
    if (!expect_list(reading, through, "'through'", 3)) return std::nullopt;
    const auto points = read_points(reading, through, "'through'");
    if (!points) return std::nullopt;
    return accept(reading, through, arc_through((*points)[0], (*points)[1], (*points)[2]));
}

MaybeCurve read_arc(Reading& reading, const YamlNode& node) {
    if (find(reading, node, "through") != nullptr) return read_arc_through(reading, node);
    if (!expect_mapping(reading, node, "'arc'", {"arc", "arc_through"})) return std::nullopt;
    const auto center = read_required<Vec3>(reading, node, "center", "'arc'", read_point);
    const auto radius = read_required<double>(reading, node, "radius", "'arc'", read_positive);
    const auto from = read_required<double>(reading, node, "from", "'arc'", read_number);
    const auto to = read_required<double>(reading, node, "to", "'arc'", read_number);
    const auto axes = read_plane(reading, node);
    if (!center || !radius || !from || !to || !axes) return std::nullopt;
    const double turn = std::abs(*to - *from);
    if (turn > 0 && turn <= 2 * std::numbers::pi * (1 + 1e-12)) {
        const double limit = 2 * std::numbers::pi;
        const double end = turn <= limit ? *to : *from + (*to > *from ? limit : -limit);
        return arc(*center, *radius, *from, end, *axes);
    }
    reading.diagnostics.error(find(reading, node, "to")->place,
                              fmt::format("this arc turns by {} radians; it must turn, and at most "
                                          "once round",
                                          *to - *from),
                              "angles are in radians: 90 degrees are pi/2");
    return std::nullopt;
}

MaybeCurve read_ellipse(Reading& reading, const YamlNode& node) {
    if (!expect_mapping(reading, node, "'ellipse'", "ellipse")) return std::nullopt;
    const auto center = read_required<Vec3>(reading, node, "center", "'ellipse'", read_point);
    const YamlNode* axes = require(reading, node, "semi_axes", "'ellipse'");
    std::optional<double> a;
    std::optional<double> b;
    if (axes != nullptr && expect_list(reading, *axes, "'semi_axes'", 2)) {
        a = read_positive(reading, axes->children[0], "a half-axis");
        b = read_positive(reading, axes->children[1], "a half-axis");
    }
    const YamlNode* turned = find(reading, node, "angle");
    const auto angle = turned == nullptr ? 0.0 : read_number(reading, *turned, "'angle'");
    const auto plane = read_plane(reading, node);
    if (!center || !a || !b || !angle || !plane) return std::nullopt;
    return ellipse(*center, *a, *b, *angle, *plane);
}

constexpr std::array<AirfoilSide, 3> sides{AirfoilSide::upper, AirfoilSide::lower,
                                           AirfoilSide::whole};

std::optional<AirfoilSide> read_side(Reading& reading, const YamlNode& entry) {
    const YamlNode* side = find(reading, entry, "side");
    if (side == nullptr) return AirfoilSide::whole;
    const auto choice = read_choice(reading, *side, "'side'", words_of("curve_naca", "side"));
    return choice ? std::optional(sides.at(*choice)) : std::nullopt;
}

/// Warns of five digits that are those of a six-digit section, NACA 64-012, without its hyphen.
void warn_of_six_digits(Reading& reading, const YamlNode& code, const std::string& digits) {
    if (digits.size() != 5 || digits[0] != '6' || digits[1] < '3' || digits[1] > '7') return;
    reading.diagnostics.warning(
        code.place,
        fmt::format("'{}' is made as a five-digit section, of a design lift of 0.9", digits),
        fmt::format("NACA {}-{}, of the six-digit series, has no formula: read its coordinates "
                    "from a file, with 'airfoil'",
                    digits.substr(0, 2), digits.substr(2)));
}

MaybeCurve read_naca(Reading& reading, const YamlNode& entry) {
    const YamlNode& code = *find(reading, entry, "naca");
    const auto digits = read_text(reading, code, "'naca'");
    const YamlNode* length = find(reading, entry, "chord");
    const auto chord = length == nullptr ? 1.0 : read_positive(reading, *length, "'chord'");
    const auto side = read_side(reading, entry);
    const YamlNode* edge = find(reading, entry, "trailing_edge");
    const auto blunt = edge == nullptr ? std::optional<std::size_t>(0)
                                       : read_choice(reading, *edge, "'trailing_edge'",
                                                     words_of("curve_naca", "trailing_edge"));
    if (!digits || !chord || !side || !blunt) return std::nullopt;
    const TrailingEdge trailing = *blunt == 0 ? TrailingEdge::sharp : TrailingEdge::blunt;
    MaybeCurve curve = accept(reading, code, naca_airfoil(*digits, *chord, *side, trailing));
    if (curve) warn_of_six_digits(reading, code, *digits);
    return curve;
}

MaybeCurve read_airfoil_curve(Reading& reading, const YamlNode& entry) {
    const YamlNode& name = *find(reading, entry, "airfoil");
    const auto file = read_data_file(reading, name, "'airfoil'");
    const auto side = read_side(reading, entry);
    const auto close = read_switch(reading, entry, "close_trailing_edge");
    const auto half = read_switch(reading, entry, "symmetric_half");
    const YamlNode* length = find(reading, entry, "chord");
    std::optional<double> chord;
    if (length != nullptr) {
        chord = read_positive(reading, *length, "'chord'");
        if (!chord) return std::nullopt;
    }
    if (!file || !side || !close || !half) return std::nullopt;
    const AirfoilContent content = *half ? AirfoilContent::symmetric_half : AirfoilContent::section;
    CurveResult result = airfoil_from_text(file->text, content, {*side, *close, chord});
    if (!result.curve) {
        tell_file_fault(reading, name, file, result.error, result.line,
                        "an airfoil's file has lines of x and y, from the trailing edge round the "
                        "nose (Selig) or from the nose twice (Lednicer); of one side alone say "
                        "'symmetric_half: true'");
    }
    return std::move(result.curve);
}

/// Where a formula is not finite, found on a fine net of its range; tells it.
bool check_finite(Reading& reading, const YamlNode& node,
                  const std::function<double(double)>& formula, double begin, double end) {
    constexpr int samples = 256;
    for (int i = 0; i <= samples; ++i) {
        const double t = begin + (end - begin) * i / samples;
        if (std::isfinite(formula(t))) continue;
        reading.diagnostics.error(node.place,
                                  fmt::format("'{}' is not finite at t = {}", shown(node.text), t),
                                  "change the formula, or take that t out of 'range'");
        return false;
    }
    return true;
}

MaybeCurve read_formula_curve(Reading& reading, const YamlNode& entry) {
    const YamlNode& node = *find(reading, entry, "formula");
    const YamlNode* range = require(reading, entry, "range", fmt::format("curve '{}'", entry.key));
    std::optional<double> begin;
    std::optional<double> end;
    if (range != nullptr && expect_list(reading, *range, "'range'", 2)) {
        begin = read_number(reading, range->children[0], "the begin of 'range'");
        end = read_number(reading, range->children[1], "the end of 'range'");
    }
    const std::size_t size = node.children.size();
    if (!node.is_sequence() || size < 2 || size > 3) {
        reading.diagnostics.error(node.place,
                                  "'formula' must be a list of two or three formulas of t",
                                  "write [x, y] or [x, y, z], as in [cos(t), sin(t)]");
        return std::nullopt;
    }
    std::array<std::function<double(double)>, 3> parts;
    parts[2] = [](double) { return 0.0; };
    bool sound = true;
    for (std::size_t i = 0; i < size; ++i) {
        auto part = read_formula(reading, node.children[i], "a part of 'formula'");
        sound = sound && part;
        if (part) parts.at(i) = std::move(*part);
    }
    if (!sound || !begin || !end) return std::nullopt;
    if (*begin >= *end) {
        reading.diagnostics.error(
            range->place, fmt::format("'range' must ascend, not run from {} to {}", *begin, *end),
            fmt::format("write [{}, {}]; 'reverse: true' runs the curve backwards", *end, *begin));
        return std::nullopt;
    }
    for (std::size_t i = 0; i < size; ++i) {
        sound = check_finite(reading, node.children[i], parts.at(i), *begin, *end) && sound;
    }
    if (!sound) return std::nullopt;
    return formula(
        [parts](double t) {
            return Vec3{parts[0](t), parts[1](t), parts[2](t)};
        },
        *begin, *end);
}

}  // namespace

std::optional<std::vector<Vec3>> read_points(Reading& reading, const YamlNode& node,
                                             const std::string& what) {
    if (node.is_mapping()) {
        if (!expect_mapping(reading, node, what, "point_file")) return std::nullopt;
        const YamlNode* file = require(reading, node, "file", what);
        if (file == nullptr) return std::nullopt;
        return read_point_file(reading, *file, "'file'");
    }
    if (!expect_list(reading, node, what)) return std::nullopt;
    std::vector<Vec3> points;
    for (const YamlNode& item : node.children) {
        const auto point = read_point(reading, item, fmt::format("a point of {}", what));
        if (point) points.push_back(*point);
    }
    if (points.size() != node.children.size()) return std::nullopt;
    return points;
}

const std::vector<CurveFamily>& curve_families() {
    static const std::vector<CurveFamily> list{
        {"line", [](Reading& r, const YamlNode& e) { return read_line(r, *e.find("line")); }},
        {"polyline",
         [](Reading& r, const YamlNode& e) { return read_polyline(r, *e.find("polyline")); }},
        {"spline", [](Reading& r, const YamlNode& e) { return read_spline(r, *e.find("spline")); }},
        {"circle", [](Reading& r, const YamlNode& e) { return read_circle(r, *e.find("circle")); }},
        {"arc", [](Reading& r, const YamlNode& e) { return read_arc(r, *e.find("arc")); }},
        {"ellipse",
         [](Reading& r, const YamlNode& e) { return read_ellipse(r, *e.find("ellipse")); }},
        {"naca", read_naca},
        {"airfoil", read_airfoil_curve},
        {"formula", read_formula_curve},
        {"nurbs", read_nurbs_curve},
        {"cad", read_cad_curve},
    };
    return list;
}

}  // namespace hexweave
