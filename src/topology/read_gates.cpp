// SPDX-License-Identifier: Apache-2.0
#include "topology/read_gates.h"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace hexweave {

namespace {

/// A gate's key, and between which limits (exclusive) it says something.
struct GateRule {
    GateMeasure measure;
    std::string_view key;
    double above;
    double below;
};

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::array<GateRule, gate_measures> rules{{
    {GateMeasure::min_scaled_jacobian, "min_scaled_jacobian", 0, 1},
    {GateMeasure::min_angle, "min_angle", 0, 90},
    {GateMeasure::max_angle, "max_angle", 90, 180},
    {GateMeasure::max_skewness, "max_skewness", 0, 1},
    {GateMeasure::max_growth, "max_growth", 1, infinity},
    {GateMeasure::max_wall_angle, "max_wall_angle", 0, 90},
    {GateMeasure::wall_spacing_error, "wall_spacing_error", 0, infinity},
}};

std::string range_text(const GateRule& rule) {
    if (rule.below == infinity) return fmt::format("above {:g}", rule.above);
    return fmt::format("between {:g} and {:g}", rule.above, rule.below);
}

void read_gate(Reading& reading, const YamlNode& node, const GateRule& rule,
               std::vector<Gate>& gates) {
    const auto limit = read_number(reading, node, fmt::format("'{}'", rule.key));
    if (!limit) return;
    if (*limit > rule.above && *limit < rule.below) {
        gates.push_back({rule.measure, *limit, node.place});
        return;
    }
    reading.diagnostics.error(
        node.place, fmt::format("'{}' must be {}, not {}", rule.key, range_text(rule), *limit),
        usage_of(reading, node));
}

}  // namespace

std::string_view gate_name(GateMeasure measure) {
    return rules.at(static_cast<std::size_t>(measure)).key;
}

std::vector<Gate> read_gates(Reading& reading, const YamlNode& mapping) {
    std::vector<Gate> gates;
    const YamlNode* node = find(reading, mapping, "require");
    if (node == nullptr) return gates;
    if (!expect_mapping(reading, *node, "'require'", "gates")) return gates;
    for (const GateRule& rule : rules) {
        const YamlNode* given = find(reading, *node, rule.key);
        if (given != nullptr) read_gate(reading, *given, rule, gates);
    }
    return gates;
}

}  // namespace hexweave
