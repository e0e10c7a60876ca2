// SPDX-License-Identifier: Apache-2.0
#include "topology/read_surface_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/surface_parts.h"
#include "topology/text.h"

namespace hexweave {

namespace {

using Range = std::array<double, 2>;

/// The value, or the end of the range that it misses by rounding.
double snapped(double value, const Range& range) {
    const double rounding = 1e-12 * (range[1] - range[0]);
    for (const double end : range) {
        if (std::abs(value - end) <= rounding) return end;
    }
    return value;
}

/// A part of one parameter's range, under its name in `range`; the whole where it is not given.
std::optional<Range> read_part(Reading& reading, const YamlNode& node, const std::string& name,
                               const Range& range, bool closed) {
    const YamlNode* given = find(reading, node, name);
    if (given == nullptr) return range;
    const auto part = read_parameter_range(reading, *given, name, range, closed);
    if (!part || (*part)[0] < (*part)[1]) return part;
    reading.diagnostics.error(given->place,
                              fmt::format("the range of {} must ascend, not run from {} to {}",
                                          name, number_text((*part)[0]), number_text((*part)[1])),
                              fmt::format("'reverse: {}' runs it backwards", name));
    return std::nullopt;
}

std::optional<Surface> read_range(Reading& reading, const YamlNode& node, const Surface& surface) {
    if (!expect_mapping(reading, node, "'range'", "surface_range")) return std::nullopt;
    const auto u = read_part(reading, node, "u", surface.range_u, surface.closed_u);
    const auto v = read_part(reading, node, "v", surface.range_v, surface.closed_v);
    return u && v ? std::optional(surface_part(surface, *u, *v)) : std::nullopt;
}

/// Whether `reverse` names u and v.
struct Backwards {
    bool u = false;
    bool v = false;
};

std::optional<Backwards> read_reverse(Reading& reading, const YamlNode& entry) {
    const YamlNode* node = find(reading, entry, "reverse");
    if (node == nullptr) return Backwards();
    const auto choice =
        read_choice(reading, *node, "'reverse'", words_of("any_surface", "reverse"));
    if (!choice) return std::nullopt;
    return Backwards{*choice != 1, *choice != 0};
}

}  // namespace

std::optional<double> read_parameter(Reading& reading, const YamlNode& node,
                                     const std::string& name, const Range& range, bool closed) {
    const auto value = read_number(reading, node, name);
    if (!value || closed) return value;
    const double at = snapped(*value, range);
    if (at >= range[0] && at <= range[1]) return at;
    reading.diagnostics.error(
        node.place,
        fmt::format("{} = {} is outside of the surface, where {} runs from {} to {}", name,
                    number_text(at), name, number_text(range[0]), number_text(range[1])),
        fmt::format("write a value from {} to {}", number_text(range[0]), number_text(range[1])));
    return std::nullopt;
}

std::optional<Range> read_parameter_range(Reading& reading, const YamlNode& node,
                                          const std::string& name, const Range& range,
                                          bool closed) {
    if (!expect_list(reading, node, fmt::format("the range of {}", name), 2)) return std::nullopt;
    const auto begin = read_parameter(reading, node.children[0], name, range, closed);
    const auto end = read_parameter(reading, node.children[1], name, range, closed);
    if (!begin || !end) return std::nullopt;
    if (*begin == *end) {
        reading.diagnostics.error(node.place, fmt::format("the range of {} is empty", name),
                                  "it has two different ends");
        return std::nullopt;
    }
    const double period = range[1] - range[0];
    const double turn = std::abs(*end - *begin);
    if (turn <= period) return Range{*begin, *end};
    if (turn <= period * (1 + 1e-12)) {
        return Range{*begin, *begin + (*begin < *end ? period : -period)};
    }
    reading.diagnostics.error(node.place,
                              fmt::format("the range of {} may not be longer than once round, {}",
                                          name, number_text(period)),
                              "without a range the curve goes once round");
    return std::nullopt;
}

std::optional<Surface> with_parameters(Reading& reading, const YamlNode& entry, Surface surface) {
    std::optional<Surface> result = std::move(surface);
    if (const YamlNode* node = find(reading, entry, "range")) {
        result = read_range(reading, *node, *result);
    }
    const auto swap = read_switch(reading, entry, "swap");
    const auto backwards = read_reverse(reading, entry);
    if (!result || !swap || !backwards) return std::nullopt;
    if (*swap) result = swapped(*result);
    if (backwards->u) result = reversed_u(*result);
    if (backwards->v) result = reversed_v(*result);
    return result;
}

}  // namespace hexweave
