// SPDX-License-Identifier: Apache-2.0
#include "topology/read_periodic.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace hexweave {

namespace {

using Map = std::variant<Vec3, RotationEntry>;

constexpr double full_turn = 2 * std::numbers::pi;

/// A unit vector along x, y or z, forwards or backwards.
std::optional<Vec3> read_axis(Reading& reading, const YamlNode& node) {
    const std::optional<Vec3> axis = read_point(reading, node, "'axis'");
    if (!axis) return std::nullopt;
    const int along = (axis->x != 0 ? 1 : 0) + (axis->y != 0 ? 1 : 0) + (axis->z != 0 ? 1 : 0);
    if (along == 1) return *axis / norm(*axis);
    reading.diagnostics.error(
        node.place, "'axis' must be along x, y or z",
        "files tell a turn by angles about these: write [1, 0, 0], [0, 1, 0] or [0, 0, 1]");
    return std::nullopt;
}

/// Not zero, and at most a full turn.
std::optional<double> read_angle(Reading& reading, const YamlNode& node) {
    const std::optional<double> angle = read_number(reading, node, "'angle'");
    if (!angle || (*angle != 0 && std::abs(*angle) <= full_turn)) return angle;
    reading.diagnostics.error(node.place,
                              "'angle' must not be zero, and at most a full turn either way",
                              "angles are in radians: a full turn is 2 * pi");
    return std::nullopt;
}

std::optional<Map> read_rotation(Reading& reading, const YamlNode& node) {
    if (!expect_mapping(reading, node, "'rotate'", "rotation")) return std::nullopt;
    const auto turn = read_turn(reading, node, "'rotate'");
    if (!turn) return std::nullopt;
    if (std::abs(turn->angle) < full_turn) return *turn;
    reading.diagnostics.error(find(reading, node, "angle")->place,
                              "a full turn leads from a side to itself",
                              "sides at the same place are joined by naming one edge or face "
                              "twice");
    return std::nullopt;
}

std::optional<Map> read_translation(Reading& reading, const YamlNode& node) {
    const std::optional<Vec3> way = read_point(reading, node, "'translate'");
    if (!way) return std::nullopt;
    if (norm(*way) > 0) return *way;
    reading.diagnostics.error(node.place, "'translate' must not be zero",
                              "sides at the same place are joined by naming one edge or face "
                              "twice");
    return std::nullopt;
}

std::optional<Located<Map>> read_map(Reading& reading, const YamlNode& node,
                                     const std::string& what) {
    const YamlNode* translate = find(reading, node, "translate");
    const YamlNode* rotate = find(reading, node, "rotate");
    if (translate == nullptr && rotate == nullptr) {
        if (has_misspelled(reading, node)) return std::nullopt;
        reading.diagnostics.error(node.key_place,
                                  fmt::format("{} lacks the key 'translate' or 'rotate'", what),
                                  "say what carries 'from' onto 'to': 'translate: [0, 1]', or "
                                  "'rotate: {axis: [1, 0, 0], angle: pi / 6}'");
        return std::nullopt;
    }
    if (translate != nullptr && rotate != nullptr) {
        reading.diagnostics.error(rotate->key_place,
                                  fmt::format("{} has both 'translate' and 'rotate'", what),
                                  "leave one out");
        return std::nullopt;
    }
    const YamlNode& given = translate != nullptr ? *translate : *rotate;
    const auto map =
        translate != nullptr ? read_translation(reading, given) : read_rotation(reading, given);
    if (!map) return std::nullopt;
    return Located<Map>{*map, given.place};
}

std::optional<PeriodicEntry> read_entry(Reading& reading, const YamlNode& node) {
    const std::string what = fmt::format("periodic interface '{}'", node.key);
    if (!expect_mapping(reading, node, what, "periodic")) return std::nullopt;
    const YamlNode* from = require(reading, node, "from", what);
    const YamlNode* to = require(reading, node, "to", what);
    std::optional<Located<Map>> map = read_map(reading, node, what);
    PeriodicEntry entry{{node.key, node.key_place}, {}, {}, {}};
    if (from != nullptr) entry.from = read_names(reading, *from, "'from'");
    if (to != nullptr) entry.to = read_names(reading, *to, "'to'");
    if (from == nullptr || to == nullptr || !map) return std::nullopt;
    entry.map = std::move(*map);
    return entry;
}

}  // namespace

std::optional<RotationEntry> read_turn(Reading& reading, const YamlNode& node,
                                       const std::string& what) {
    const YamlNode* given_axis = find(reading, node, "axis");
    const YamlNode* given_center = find(reading, node, "center");
    const YamlNode* given_angle = require(reading, node, "angle", what);
    const auto axis = given_axis == nullptr ? Vec3{0, 0, 1} : read_axis(reading, *given_axis);
    const auto center =
        given_center == nullptr ? Vec3{} : read_point(reading, *given_center, "'center'");
    const auto angle = given_angle == nullptr ? std::nullopt : read_angle(reading, *given_angle);
    if (!axis || !center || !angle) return std::nullopt;
    return RotationEntry{*axis, *center, *angle};
}

std::vector<PeriodicEntry> read_periodic(Reading& reading, const YamlNode& section) {
    std::vector<PeriodicEntry> entries;
    for (const YamlNode& node : section.children) {
        check_new_name(reading, node, "periodic interface", 32);
        if (auto entry = read_entry(reading, node)) entries.push_back(std::move(*entry));
    }
    return entries;
}

}  // namespace hexweave
