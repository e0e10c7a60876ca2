// SPDX-License-Identifier: Apache-2.0
#include "topology/read_surface_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "geometry/lines.h"
#include "geometry/surface_curves.h"
#include "geometry/surface_projection.h"
#include "geometry/transform.h"
#include "topology/read_data_file.h"
#include "topology/read_surface_parameters.h"
#include "topology/text.h"

namespace hexweave {

namespace {

/// Points farther from the surface are a slip. [sizes of the surface]
constexpr double near_surface = 1e-2;

using Range = std::array<double, 2>;

/// One of the two parameters of a surface.
struct Parameter {
    std::string name;
    Range range{};
    bool closed = false;
};

Parameter parameter_u(const Surface& s) {
    return {"u", s.range_u, s.closed_u};
}

Parameter parameter_v(const Surface& s) {
    return {"v", s.range_v, s.closed_v};
}

/// The line on which `fixed` is `at`, over a range of `running` that may descend.
Curve line_at(const Surface& surface, const Parameter& fixed, double at, const Range& running) {
    const auto [low, high] = std::minmax(running[0], running[1]);
    Curve line = fixed.name == "u" ? line_of_equal_u(surface, at, low, high)
                                   : line_of_equal_v(surface, at, low, high);
    return running[1] < running[0] ? reversed(line) : line;
}

/// `u: 0.3`, with or without `v: [a, b]`; or the other way round.
MaybeCurve read_line_of_equal(Reading& reading, const YamlNode& entry, const Surface& surface) {
    Parameter fixed = parameter_u(surface);
    Parameter running = parameter_v(surface);
    const YamlNode* at = find(reading, entry, "u");
    const YamlNode* over = find(reading, entry, "v");
    if (at == nullptr || at->is_sequence()) {
        std::swap(fixed, running);
        std::swap(at, over);
    }
    if (at == nullptr || at->is_sequence()) {
        reading.diagnostics.error(entry.key_place,
                                  fmt::format("curve '{}' has no fixed parameter", entry.key),
                                  "write u: NUMBER for a line of equal u, or v: NUMBER");
        return std::nullopt;
    }
    const auto value = read_parameter(reading, *at, fixed.name, fixed.range, fixed.closed);
    std::optional<Range> range = running.range;
    if (over != nullptr) {
        range = read_parameter_range(reading, *over, running.name, running.range, running.closed);
    }
    if (!value || !range) return std::nullopt;
    return line_at(surface, fixed, *value, *range);
}

MaybeCurve read_side_of(Reading& reading, const YamlNode& node, const Surface& surface) {
    const auto side = read_choice(reading, node, "'side'", words_of("curve_of_side", "side"));
    if (!side) return std::nullopt;
    const Parameter u = parameter_u(surface);
    const Parameter v = parameter_v(surface);
    const bool of_u = *side < 2;
    return line_at(surface, of_u ? u : v, (of_u ? u : v).range.at(*side % 2), (of_u ? v : u).range);
}

/// Tells of a point that is projected from too far away; false then.
bool check_near(Reading& reading, const YamlNode& node, const Vec3& point, double distance,
                double size) {
    if (distance <= near_surface * size) return true;
    reading.diagnostics.error(node.place,
                              fmt::format("the point {} is {} away from the surface",
                                          point_text(point), number_text(distance)),
                              fmt::format("points are projected on it, and may be {} away",
                                          number_text(near_surface * size)));
    return false;
}

/// [u, v], or [x, y, z] for the nearest point of the surface.
std::optional<Vec3> read_end(Reading& reading, const YamlNode& node, const Surface& surface) {
    if (node.is_sequence() && node.children.size() == 3) {
        const auto point = read_point(reading, node, "an end of 'line'");
        if (!point) return std::nullopt;
        const SurfaceProjection projection(surface);
        const SurfacePoint foot = projection.nearest(*point);
        if (!check_near(reading, node, *point, foot.distance, projection.size())) {
            return std::nullopt;
        }
        return Vec3{foot.parameters.u, foot.parameters.v, 0};
    }
    if (!expect_list(reading, node, "an end of 'line'", 2)) return std::nullopt;
    const auto u =
        read_parameter(reading, node.children[0], "u", surface.range_u, surface.closed_u);
    const auto v =
        read_parameter(reading, node.children[1], "v", surface.range_v, surface.closed_v);
    return u && v ? std::optional(Vec3{*u, *v, 0}) : std::nullopt;
}

MaybeCurve read_line_between(Reading& reading, const YamlNode& node, const Surface& surface) {
    if (!expect_list(reading, node, "'line'", 2)) return std::nullopt;
    const auto from = read_end(reading, node.children[0], surface);
    const auto to = read_end(reading, node.children[1], surface);
    if (!from || !to) return std::nullopt;
    if (!(*from == *to)) return curve_on(surface, straight_line(*from, *to));
    reading.diagnostics.error(node.place, "the two ends of this line are the same",
                              "a line is drawn between two different points");
    return std::nullopt;
}

MaybeCurve read_curve_through(Reading& reading, const YamlNode& entry, const Surface& surface) {
    const YamlNode& node = *find(reading, entry, "points");
    const auto points = read_points(reading, node, "'points'");
    const auto corner = read_switch(reading, entry, "corner");
    if (!points || !corner) return std::nullopt;
    const ProjectedCurve made = curve_through(surface, *points, *corner);
    if (!made.fault.empty()) {
        reading.diagnostics.error(node.place, made.fault, usage_of(reading, node));
        return std::nullopt;
    }
    if (!check_near(reading, node, (*points)[made.farthest], made.distance, made.size)) {
        return std::nullopt;
    }
    return made.curve;
}

/// Whether a curve has a length: the side of a surface may be a point.
bool has_length(const Curve& curve) {
    constexpr int samples = 8;
    const Vec3 start = curve.position(curve.begin);
    for (int n = 1; n <= samples; ++n) {
        const double t = curve.begin + curve.period() * n / samples;
        if (distance(start, curve.position(t)) > 1e-14 * (1 + norm(start))) return true;
    }
    return false;
}

}  // namespace

MaybeCurve read_surface_curve(Shapes& shapes, const YamlNode& entry) {
    Reading& reading = shapes.reading;
    const auto surface = use_surface(shapes, *find(reading, entry, "surface"), "'surface'");
    std::vector<const YamlNode*> ways;
    for (const std::string_view key : {"u", "side", "line", "points"}) {
        const YamlNode* node = find(reading, entry, key);
        if (node == nullptr && key == "u") node = find(reading, entry, "v");
        if (node != nullptr) ways.push_back(node);
    }
    if (ways.size() != 1) {
        reading.diagnostics.error(
            entry.key_place,
            fmt::format("curve '{}' must say in one way where it lies on its surface", entry.key),
            "by u or v, by side, by line, or by points");
        return std::nullopt;
    }
    if (!surface) return std::nullopt;
    const YamlNode& way = *ways.front();
    MaybeCurve curve;
    if (find(reading, entry, "side") != nullptr) {
        curve = read_side_of(reading, way, *surface);
    } else if (find(reading, entry, "line") != nullptr) {
        curve = read_line_between(reading, way, *surface);
    } else if (find(reading, entry, "points") != nullptr) {
        curve = read_curve_through(reading, entry, *surface);
    } else {
        curve = read_line_of_equal(reading, entry, *surface);
    }
    if (!curve || has_length(*curve)) return curve;
    reading.diagnostics.error(entry.key_place, fmt::format("curve '{}' has no length", entry.key),
                              "the surface shrinks to a point there");
    return std::nullopt;
}

}  // namespace hexweave
