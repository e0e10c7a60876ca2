// SPDX-License-Identifier: Apache-2.0
// Boundaries.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "topology/read_entries.h"

namespace hexweave {

namespace {

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Whether what should be a boundary condition says that the sides are joined with others.
bool is_about_joining(const YamlNode& type) {
    std::string lower = type.text;
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower.find("periodic") != std::string::npos ||
           lower.find("interface") != std::string::npos ||
           lower.find("cyclic") != std::string::npos;
}

std::vector<Name> read_sides(Reading& reading, const YamlNode& node) {
    if (!node.is_sequence()) return {read_name(reading, node, "'sides'")};
    std::vector<Name> sides;
    for (const YamlNode& item : node.children) sides.push_back(read_name(reading, item, "a side"));
    if (sides.empty()) {
        reading.diagnostics.error(node.place, "'sides' names nothing", usage_of(reading, node));
    }
    return sides;
}

BoundaryEntry read_boundary(Reading& reading, const YamlNode& node) {
    const std::string what = fmt::format("boundary '{}'", shown(node.key));
    BoundaryEntry boundary;
    boundary.name = {node.key, node.key_place};
    if (!expect_mapping(reading, node, what, "boundary")) return boundary;
    if (const YamlNode* type = require(reading, node, "type", what)) {
        boundary.type.place = type->place;
        if (is_about_joining(*type)) {
            reading.diagnostics.error(
                type->place,
                fmt::format("sides that are joined are no boundary, not of type '{}'",
                            shown(type->text)),
                "sides that are images of each other stand under 'periodic: {NAME: {from: ..., to: "
                "..., translate: ...}}'; faces (blocks) that share a side are joined anyway");
        } else if (read_choice(reading, *type, "'type'", words_of("boundary", "type"))) {
            boundary.type.value = type->text;
        }
    }
    const YamlNode* sides = find(reading, node, "sides");
    if (sides != nullptr) boundary.sides = read_sides(reading, *sides);
    boundary.lacks_sides = sides == nullptr && !has_misspelled(reading, node);
    if (const YamlNode* plane = find(reading, node, "plane")) {
        const auto read = read_axis_plane(reading, *plane);
        if (read) boundary.plane = {*read, plane->place};
    }
    return boundary;
}

}  // namespace

std::optional<AxisPlane> read_axis_plane(Reading& reading, const YamlNode& node) {
    const std::size_t equals = node.is_scalar() ? node.text.find('=') : std::string::npos;
    const std::string axis =
        equals == std::string::npos ? "" : trimmed(node.text.substr(0, equals));
    const std::size_t which = std::string("xyz").find(axis);
    if (axis.size() != 1 || which == std::string::npos) {
        reading.diagnostics.error(
            node.place,
            fmt::format("'plane' must be an axis and its value, not {}", describe(node)),
            "write \"z = 0\", or x or y for z");
        return std::nullopt;
    }
    const std::size_t begin = node.text.find_first_not_of(" \t", equals + 1);
    YamlNode value = node;
    value.text = begin == std::string::npos ? "" : node.text.substr(begin);
    value.place = place_in(node, std::min(begin, node.text.size()), value.text.size());
    if (node.text_column > 0) value.text_column = value.place.column;
    const auto number = read_number(reading, value, "the value of 'plane'");
    if (!number) return std::nullopt;
    return AxisPlane{static_cast<int>(which), *number};
}

std::vector<BoundaryEntry> read_boundaries(Reading& reading, const YamlNode& section) {
    std::vector<BoundaryEntry> boundaries;
    for (const YamlNode& node : section.children) {
        check_new_name(reading, node, "boundary", longest_zone_name);
        boundaries.push_back(read_boundary(reading, node));
    }
    return boundaries;
}

}  // namespace hexweave
