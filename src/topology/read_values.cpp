// SPDX-License-Identifier: Apache-2.0
#include "topology/read_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "topology/instance_scope.h"

namespace hexweave {

namespace {

// No grid has an edge of more cells; a slip of some powers of ten is told before it is tried.
constexpr double largest_count = 10'000'000;

std::optional<double> tell_fault(Reading& reading, const YamlNode& node,
                                 const ExpressionFault& fault) {
    if (!fault.message.empty()) {
        reading.diagnostics.error(place_in(node, fault.offset, fault.length), fault.message,
                                  fault.hint);
    }
    return std::nullopt;
}

bool expect_scalar(Reading& reading, const YamlNode& node, const std::string& what,
                   std::string_view expected) {
    if (node.is_scalar() && !node.text.empty()) return true;
    const std::string usage = usage_of(reading, node);
    reading.diagnostics.error(node.place,
                              fmt::format("{} must be {}, not {}", what, expected, describe(node)),
                              usage.empty() ? fmt::format("write {} here", expected) : usage);
    return false;
}

/// The whole numbers beside a value, as they are written.
std::string rounding_hint(const YamlNode& node, double value) {
    const bool plain = node.text.find_first_not_of("0123456789.eE+-") == std::string::npos;
    if (!plain) return fmt::format("round it: 'floor({0})' or 'ceil({0})'", shown(node.text));
    if (value < 1) return "write 1 or more";
    return fmt::format("write {:.0f} or {:.0f}", std::floor(value), std::ceil(value));
}

/// What a word stands for that YAML 1.1 reads as a truth value; empty for others.
std::string meant_truth(const std::string& text) {
    std::string lower = text;
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    for (const char* word : {"true", "yes", "on", "1"}) {
        if (lower == word) return "true";
    }
    for (const char* word : {"false", "no", "off", "0"}) {
        if (lower == word) return "false";
    }
    return {};
}

}  // namespace

ParameterScope& parameters_at(Reading& reading, const YamlNode& node) {
    return node.scope ? node.scope->parameters : reading.parameters;
}

std::string describe(const YamlNode& node) {
    switch (node.kind) {
        case YamlNode::Kind::null:
            return "nothing";
        case YamlNode::Kind::sequence:
            return "a list";
        case YamlNode::Kind::mapping:
            return "a mapping";
        case YamlNode::Kind::scalar:
            break;
    }
    if (node.text.empty()) return "an empty text";
    return fmt::format("'{}'", shown(node.text));
}

Place place_in(const YamlNode& node, std::size_t offset, std::size_t length) {
    Place place = node.place;
    if (node.text_column == 0 || offset > node.text.size()) return place;
    const std::string_view text = node.text;
    place.column = node.text_column + count_characters(text.substr(0, offset));
    place.length = std::max(1, count_characters(text.substr(offset, length)));
    return place;
}

std::optional<double> read_number(Reading& reading, const YamlNode& node, const std::string& what) {
    if (!expect_scalar(reading, node, what, "a number or an expression")) return std::nullopt;
    const auto result = evaluate(node.text, parameters_at(reading, node));
    if (const double* value = std::get_if<double>(&result)) return *value;
    return tell_fault(reading, node, std::get<ExpressionFault>(result));
}

std::optional<double> read_positive(Reading& reading, const YamlNode& node,
                                    const std::string& what) {
    const std::optional<double> value = read_number(reading, node, what);
    if (!value || *value > 0) return value;
    const std::string number = fmt::format("{}", *value);
    reading.diagnostics.error(
        node.place,
        number == node.text
            ? fmt::format("{} must be positive, not {}", what, number)
            : fmt::format("{} must be positive; '{}' is {}", what, shown(node.text), number),
        usage_of(reading, node));
    return std::nullopt;
}

std::optional<int> read_count(Reading& reading, const YamlNode& node, const std::string& what,
                              std::string (*too_many)(double)) {
    const std::optional<double> value = read_number(reading, node, what);
    if (!value) return std::nullopt;
    const double whole = std::round(*value);
    const std::string number = fmt::format("{:.12g}", *value);
    const std::string is = number == node.text
                               ? fmt::format(", not {}", number)
                               : fmt::format("; '{}' is {}", shown(node.text), number);
    if (std::abs(*value - whole) > 1e-9 * std::max(1.0, std::abs(whole))) {
        reading.diagnostics.error(node.place, fmt::format("{} must be a whole number{}", what, is),
                                  rounding_hint(node, *value));
        return std::nullopt;
    }
    if (whole < 1 || whole > largest_count) {
        const bool tell = whole > largest_count && too_many != nullptr;
        reading.diagnostics.error(node.place,
                                  fmt::format("{} must lie between 1 and {}{}", what,
                                              static_cast<int>(largest_count), is),
                                  tell ? too_many(whole) : usage_of(reading, node));
        return std::nullopt;
    }
    return static_cast<int>(whole);
}

std::optional<Located<int>> read_multiple_of(Reading& reading, const YamlNode& mapping) {
    const YamlNode* node = find(reading, mapping, "multiple_of");
    if (node == nullptr) return std::nullopt;
    const auto multiple = read_count(reading, *node, "'multiple_of'");
    return multiple ? std::optional(Located<int>{*multiple, node->place}) : std::nullopt;
}

std::optional<Vec3> read_point(Reading& reading, const YamlNode& node, const std::string& what) {
    const std::size_t size = node.children.size();
    if (!node.is_sequence() || size < 2 || size > 3) {
        reading.diagnostics.error(
            node.place,
            fmt::format("{} must be two or three numbers, not {}", what,
                        node.is_sequence() ? fmt::format("{}", size) : describe(node)),
            size > 3 ? "write [x, y] or [x, y, z]; the decimal separator is the point"
                     : "write [x, y] or [x, y, z]");
        return std::nullopt;
    }
    static constexpr std::array<std::string_view, 3> axis{"x", "y", "z"};
    std::array<double, 3> numbers{};
    bool sound = true;
    for (std::size_t i = 0; i < size; ++i) {
        const auto number =
            read_number(reading, node.children[i], fmt::format("{} of {}", axis[i], what));
        numbers[i] = number.value_or(0);
        sound = sound && number;
    }
    if (!sound) return std::nullopt;
    return Vec3{numbers[0], numbers[1], numbers[2]};
}

std::optional<std::function<double(double)>> read_formula(Reading& reading, const YamlNode& node,
                                                          const std::string& what) {
    if (!expect_scalar(reading, node, what, "a formula of t")) return std::nullopt;
    auto result = compile(node.text, "t", parameters_at(reading, node));
    if (auto* formula = std::get_if<std::function<double(double)>>(&result)) return *formula;
    tell_fault(reading, node, std::get<ExpressionFault>(result));
    return std::nullopt;
}

std::optional<std::function<double(double, double)>> read_formula_of_uv(Reading& reading,
                                                                        const YamlNode& node,
                                                                        const std::string& what) {
    if (!expect_scalar(reading, node, what, "a formula of u and v")) return std::nullopt;
    auto result =
        compile(node.text, std::array<std::string, 2>{"u", "v"}, parameters_at(reading, node));
    if (auto* formula = std::get_if<std::function<double(double, double)>>(&result)) {
        return *formula;
    }
    tell_fault(reading, node, std::get<ExpressionFault>(result));
    return std::nullopt;
}

std::optional<bool> read_switch(Reading& reading, const YamlNode& mapping, std::string_view key) {
    const YamlNode* node = find(reading, mapping, key);
    if (node == nullptr) return false;
    if (node->is_scalar() && node->text == "true") return true;
    if (node->is_scalar() && node->text == "false") return false;
    const std::string meant = node->is_scalar() ? meant_truth(node->text) : "";
    reading.diagnostics.error(
        node->place, fmt::format("'{}' must be true or false, not {}", key, describe(*node)),
        meant.empty() ? usage_of(reading, *node) : fmt::format("write {}: {}", key, meant));
    return std::nullopt;
}

std::optional<std::string> read_text(Reading& reading, const YamlNode& node,
                                     const std::string& what) {
    if (!expect_scalar(reading, node, what, "a text")) return std::nullopt;
    return node.text;
}

std::optional<std::size_t> read_choice(Reading& reading, const YamlNode& node,
                                       const std::string& what, const Keys& choices) {
    if (!expect_scalar(reading, node, what, fmt::format("one of {}", fmt::join(choices, ", ")))) {
        return std::nullopt;
    }
    const auto found = std::find(choices.begin(), choices.end(), node.text);
    if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
    reading.diagnostics.error(node.place, fmt::format("{} cannot be '{}'", what, shown(node.text)),
                              suggestion(node.text, choices, "it is one of"));
    return std::nullopt;
}

}  // namespace hexweave
