// SPDX-License-Identifier: Apache-2.0
#include "topology/read_heights.h"

#include <fmt/format.h>

namespace hexweave {

namespace {

/// The number under a key if it passes `fits`, else an error that says how it must be; the value
/// that is there already where the key is not.
template <class Fits>
void read_bounded(Reading& reading, const YamlNode& node, std::string_view key,
                  std::string_view must, Fits fits, double& value) {
    const YamlNode* given = find(reading, node, key);
    if (given == nullptr) return;
    const auto number = read_number(reading, *given, fmt::format("'{}'", key));
    if (!number) return;
    if (fits(*number)) {
        value = *number;
        return;
    }
    reading.diagnostics.error(given->place,
                              fmt::format("'{}' must be {}, not {}", key, must, *number),
                              usage_of(reading, *given));
}

std::optional<HeldHeights> read_held(Reading& reading, const YamlNode& node) {
    const std::string what = fmt::format("'{}' of 'heights'", shown(node.key));
    HeldHeights held;
    if (node.is_scalar() && node.text == "held") return held;
    if (!node.is_mapping()) {
        reading.diagnostics.error(
            node.place, fmt::format("{} must be 'held' or a mapping, not {}", what, describe(node)),
            "write held, or {height: SIZE} for a height other than that of the edges");
        return std::nullopt;
    }
    expect_mapping(reading, node, what, "held_height");
    if (const YamlNode* height = find(reading, node, "height")) {
        held.height = read_positive(reading, *height, "'height'");
    }
    read_bounded(
        reading, node, "fade", "above 0 and at most 1, a part of the side's length",
        [](double fade) { return fade > 0 && fade <= 1; }, held.fade);
    read_bounded(
        reading, node, "growth", "greater than 1, the ratio of two neighbouring cells",
        [](double growth) { return growth > 1; }, held.growth);
    return held;
}

}  // namespace

HeightRequests read_heights(Reading& reading, const YamlNode& entry, const FormatNames& format) {
    HeightRequests requests;
    const YamlNode* node = find(reading, entry, "heights");
    if (node == nullptr) return requests;
    if (!expect_mapping(reading, *node, "'heights'", format)) return requests;
    const Keys sides = keys_of(format);
    for (std::size_t side = 0; side < sides.size(); ++side) {
        const YamlNode* given = find(reading, *node, sides[side]);
        if (given != nullptr) requests.at(side) = read_held(reading, *given);
    }
    return requests;
}

}  // namespace hexweave
