// SPDX-License-Identifier: Apache-2.0
#include "topology/read_transforms.h"

#include <fmt/format.h>

#include <algorithm>

namespace hexweave {

namespace {

const Keys& map_keys() {
    static const Keys keys{"scale", "rotate", "translate", "mirror"};
    return keys;
}

/// The point `about` which a map works; the origin where it is not given.
std::optional<Vec3> read_about(Reading& reading, const YamlNode& node) {
    const YamlNode* about = find(reading, node, "about");
    return about == nullptr ? Vec3{} : read_point(reading, *about, "'about'");
}

std::optional<Vec3> read_factors(Reading& reading, const YamlNode& node) {
    std::optional<Vec3> factors;
    if (node.is_sequence()) {
        factors = read_point(reading, node, "'scale'");
        if (factors && node.children.size() == 2) factors->z = 1;
    } else if (const auto factor = read_number(reading, node, "'scale'")) {
        factors = Vec3{*factor, *factor, *factor};
    }
    if (factors && (factors->x == 0 || factors->y == 0 || factors->z == 0)) {
        reading.diagnostics.error(node.place, "a factor of 'scale' must not be zero",
                                  "1 leaves a direction as it is");
        return std::nullopt;
    }
    return factors;
}

/// A vector that must not be zero.
std::optional<Vec3> read_direction(Reading& reading, const YamlNode& node,
                                   const std::string& what) {
    const std::optional<Vec3> direction = read_point(reading, node, what);
    if (!direction || norm(*direction) > 0) return direction;
    reading.diagnostics.error(node.place, fmt::format("{} must not be zero", what),
                              usage_of(reading, node));
    return std::nullopt;
}

std::optional<Affine> read_scale(Reading& reading, const YamlNode& holder) {
    const auto factors = read_factors(reading, *find(reading, holder, "scale"));
    const auto about = read_about(reading, holder);
    if (!factors || !about) return std::nullopt;
    return scaling(*factors, *about);
}

std::optional<Affine> read_rotate(Reading& reading, const YamlNode& holder) {
    const auto angle = read_number(reading, *find(reading, holder, "rotate"), "'rotate'");
    const YamlNode* given = find(reading, holder, "axis");
    const auto axis = given == nullptr ? Vec3{0, 0, 1} : read_direction(reading, *given, "'axis'");
    const auto about = read_about(reading, holder);
    if (!angle || !axis || !about) return std::nullopt;
    return rotation(*axis, *angle, *about);
}

std::optional<Affine> read_translate(Reading& reading, const YamlNode& holder) {
    const auto by = read_point(reading, *find(reading, holder, "translate"), "'translate'");
    return by ? std::optional(translation(*by)) : std::nullopt;
}

std::optional<Affine> read_mirror(Reading& reading, const YamlNode& holder) {
    const YamlNode& node = *find(reading, holder, "mirror");
    if (!expect_mapping(reading, node, "'mirror'", "mirror")) return std::nullopt;
    const YamlNode* given = require(reading, node, "normal", "'mirror'");
    if (given == nullptr) return std::nullopt;
    const auto normal = read_direction(reading, *given, "'normal'");
    const auto about = read_about(reading, node);
    if (!normal || !about) return std::nullopt;
    return reflection(*about, *normal);
}

std::optional<Affine> read_map(Reading& reading, const YamlNode& holder, std::string_view map) {
    if (map == "scale") return read_scale(reading, holder);
    if (map == "rotate") return read_rotate(reading, holder);
    if (map == "translate") return read_translate(reading, holder);
    return read_mirror(reading, holder);
}

/// The maps whose keys stand in a mapping.
std::vector<const YamlNode*> maps_in(const YamlNode& holder) {
    std::vector<const YamlNode*> found;
    for (const YamlNode& child : holder.children) {
        const bool is_map =
            std::find(map_keys().begin(), map_keys().end(), child.key) != map_keys().end();
        if (is_map) found.push_back(&child);
    }
    return found;
}

std::optional<Affine> read_item(Reading& reading, const YamlNode& item) {
    const std::string choice = fmt::format("{}", fmt::join(map_keys(), ", "));
    const std::vector<const YamlNode*> maps =
        item.is_mapping() ? maps_in(item) : std::vector<const YamlNode*>();
    if (maps.size() != 1) {
        reading.diagnostics.error(item.place,
                                  "an item of 'transform' must be a mapping with one of " + choice,
                                  "write [{rotate: pi/2}, {translate: [1, 0]}]");
        return std::nullopt;
    }
    const std::string& map = maps.front()->key;
    expect_mapping(reading, item, fmt::format("'{}'", map), FormatNames("transform_" + map));
    return read_map(reading, item, map);
}

std::optional<std::vector<Affine>> read_list(Reading& reading, const YamlNode& list) {
    if (!expect_list(reading, list, "'transform'")) return std::nullopt;
    std::vector<Affine> maps;
    for (const YamlNode& item : list.children) {
        if (const auto map = read_item(reading, item)) maps.push_back(*map);
    }
    if (maps.size() != list.children.size()) return std::nullopt;
    return maps;
}

/// `about` and `axis` without a map that they belong to.
bool check_companions(Reading& reading, const YamlNode& entry, const std::string& map) {
    const Keys allowed = map.empty() ? Keys() : keys_of(FormatNames("transform_" + map));
    bool sound = true;
    for (const std::string_view key : {"about", "axis"}) {
        const YamlNode* node = find(reading, entry, key);
        if (node == nullptr || std::find(allowed.begin(), allowed.end(), key) != allowed.end())
            continue;
        reading.diagnostics.error(
            node->key_place, fmt::format("'{}' belongs to nothing here", key),
            key == "axis" ? "it goes with 'rotate'" : "it goes with 'scale' or 'rotate'");
        sound = false;
    }
    return sound;
}

}  // namespace

std::optional<std::vector<Affine>> read_transforms(Reading& reading, const YamlNode& entry,
                                                   const std::string& what) {
    const std::vector<const YamlNode*> maps = maps_in(entry);
    const YamlNode* list = find(reading, entry, "transform");
    if (maps.size() > 1 || (list != nullptr && !maps.empty())) {
        reading.diagnostics.error(maps.back()->key_place,
                                  fmt::format("{} has several transforms without an order", what),
                                  "write transform: [{...}, {...}], applied from left to right");
        return std::nullopt;
    }
    if (!check_companions(reading, entry, maps.empty() ? "" : maps.front()->key)) {
        return std::nullopt;
    }
    if (list != nullptr) return read_list(reading, *list);
    if (maps.empty()) return std::vector<Affine>();
    const std::optional<Affine> map = read_map(reading, entry, maps.front()->key);
    return map ? std::optional(std::vector{*map}) : std::nullopt;
}

}  // namespace hexweave
