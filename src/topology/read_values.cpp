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
    reading.diagnostics.error(node.place,
                              fmt::format("{} must be {}, not {}", what, expected, describe(node)));
    return false;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_name(std::string_view text, std::string_view further) {
    const auto letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    return !text.empty() && letter(text.front()) &&
           std::all_of(text.begin(), text.end(), [&](char c) {
               return letter(c) || is_digit(c) || further.find(c) != std::string::npos;
           });
}

/// YAML 1.1 reads these as truth values: other programs would take such a name for one.
bool is_yaml_switch(const std::string& text) {
    static constexpr std::array<std::string_view, 9> words{"y",   "n",    "yes",   "no",  "on",
                                                           "off", "true", "false", "null"};
    std::string lower = text;
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return std::find(words.begin(), words.end(), lower) != words.end();
}

void tell_unknown_key(Reading& reading, const YamlNode& mapping, const YamlNode& child,
                      const std::string& what, const Keys& keys) {
    const bool decimals = child.is_null() && !child.key.empty() && is_digit(child.key.front());
    const std::string meant = nearest_name(child.key, {keys.begin(), keys.end()});
    if (!meant.empty()) reading.misspelled.push_back({&mapping, &child, meant});
    reading.diagnostics.error(child.key_place,
                              fmt::format("unknown key '{}' in {}", shown(child.key), what),
                              decimals ? "a comma separates entries; the decimal separator is "
                                         "the point"
                                       : suggestion(child.key, keys, "keys here are"));
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

std::string suggestion(const std::string& name, const Keys& known, std::string_view label) {
    const std::string nearest = nearest_name(name, {known.begin(), known.end()});
    if (!nearest.empty()) return fmt::format("did you mean '{}'?", nearest);
    return fmt::format("{} {}", label, fmt::join(known, ", "));
}

bool expect_mapping(Reading& reading, const YamlNode& node, const std::string& what,
                    const FormatNames& formats, const std::vector<RefusedKey>& refused) {
    const Keys keys = keys_of(formats);
    if (!node.is_mapping()) {
        reading.diagnostics.error(node.place,
                                  fmt::format("{} must be a mapping, not {}", what, describe(node)),
                                  fmt::format("its keys are {}", fmt::join(keys, ", ")));
        return false;
    }
    for (const YamlNode& child : node.children) {
        if (std::find(keys.begin(), keys.end(), child.key) != keys.end()) continue;
        const auto special = std::find_if(refused.begin(), refused.end(),
                                          [&](const RefusedKey& r) { return r.key == child.key; });
        if (special != refused.end()) {
            reading.diagnostics.error(child.key_place, std::string(special->message),
                                      std::string(special->hint));
        } else {
            tell_unknown_key(reading, node, child, what, keys);
        }
    }
    return true;
}

const YamlNode* find(const Reading& reading, const YamlNode& mapping, std::string_view key) {
    if (const YamlNode* value = mapping.find(key)) return value;
    const auto meant = std::find_if(
        reading.misspelled.begin(), reading.misspelled.end(),
        [&](const MisspelledKey& m) { return m.mapping == &mapping && m.meant == key; });
    return meant == reading.misspelled.end() ? nullptr : meant->value;
}

bool has_misspelled(const Reading& reading, const YamlNode& mapping) {
    return std::any_of(reading.misspelled.begin(), reading.misspelled.end(),
                       [&](const MisspelledKey& m) { return m.mapping == &mapping; });
}

const YamlNode* require(Reading& reading, const YamlNode& mapping, std::string_view key,
                        const std::string& what) {
    const YamlNode* value = find(reading, mapping, key);
    if (value == nullptr) tell_lacking(reading, mapping, {key}, what);
    return value;
}

void tell_lacking(Reading& reading, const YamlNode& mapping, const Keys& keys,
                  const std::string& what) {
    std::vector<std::string> lacking;
    for (const std::string_view key : keys) {
        if (find(reading, mapping, key) != nullptr) continue;
        lacking.push_back(fmt::format("'{}'", key));
    }
    if (lacking.empty()) return;
    reading.diagnostics.error(mapping.key_place.line > 0 ? mapping.key_place : mapping.place,
                              fmt::format("{} lacks the key{} {}", what,
                                          lacking.size() > 1 ? "s" : "", fmt::join(lacking, ", ")));
}

bool expect_list(Reading& reading, const YamlNode& node, const std::string& what,
                 std::size_t count) {
    if (node.is_sequence() && (count == 0 || node.children.size() == count)) return true;
    const std::string size = count == 0 ? "a list" : fmt::format("a list of {}", count);
    const std::string found =
        node.is_sequence() ? fmt::format("of {}", node.children.size()) : describe(node);
    reading.diagnostics.error(node.place, fmt::format("{} must be {}, not {}", what, size, found));
    return false;
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
    const std::string shown = fmt::format("{}", *value);
    reading.diagnostics.error(
        node.place, shown == node.text
                        ? fmt::format("{} must be positive, not {}", what, shown)
                        : fmt::format("{} must be positive; '{}' is {}", what, node.text, shown));
    return std::nullopt;
}

std::optional<int> read_count(Reading& reading, const YamlNode& node, const std::string& what,
                              std::string (*too_many)(double)) {
    const std::optional<double> value = read_number(reading, node, what);
    if (!value) return std::nullopt;
    const double whole = std::round(*value);
    const std::string shown = fmt::format("{:.12g}", *value);
    const std::string is = shown == node.text ? fmt::format(", not {}", shown)
                                              : fmt::format("; '{}' is {}", node.text, shown);
    if (std::abs(*value - whole) > 1e-9 * std::max(1.0, std::abs(whole))) {
        reading.diagnostics.error(node.place, fmt::format("{} must be a whole number{}", what, is));
        return std::nullopt;
    }
    if (whole < 1 || whole > largest_count) {
        const bool tell = whole > largest_count && too_many != nullptr;
        reading.diagnostics.error(node.place,
                                  fmt::format("{} must lie between 1 and {}{}", what,
                                              static_cast<int>(largest_count), is),
                                  tell ? too_many(whole) : "");
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
            "write [x, y] or [x, y, z]");
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
    reading.diagnostics.error(
        node->place, fmt::format("'{}' must be true or false, not {}", key, describe(*node)));
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

bool check_new_name(Reading& reading, const YamlNode& node, const std::string& kind,
                    std::size_t longest) {
    const std::string name = local_name(node.key, node.scope);
    if (!is_name(name, "")) {
        reading.diagnostics.error(
            node.key_place, fmt::format("'{}' is not a valid {} name", shown(name), kind),
            "a name has letters (a-z, A-Z), digits and underscores, and no digit first");
    } else if (is_yaml_switch(name)) {
        reading.diagnostics.error(node.key_place,
                                  fmt::format("'{}' is not a valid {} name", shown(name), kind),
                                  "other YAML programs read it as true, false or null");
    } else if (node.key.size() > longest) {
        reading.diagnostics.error(
            node.key_place,
            fmt::format("the name of this {} has {} characters; at most {} are allowed", kind,
                        node.key.size(), longest),
            name == node.key ? "" : fmt::format("it is '{}' in full", shown(node.key)));
    } else {
        return true;
    }
    return false;
}

Name read_name(Reading& reading, const YamlNode& node, const std::string& what) {
    if (node.is_scalar() && is_name(node.text, "-.")) {
        return {qualified(node.text, node.scope), node.place};
    }
    reading.diagnostics.error(node.place,
                              fmt::format("{} must be a name, not {}", what, describe(node)));
    return {{}, node.place};
}

std::vector<Name> read_names(Reading& reading, const YamlNode& node, const std::string& what) {
    if (!node.is_sequence()) return {read_name(reading, node, what)};
    std::vector<Name> names;
    for (const YamlNode& item : node.children) {
        Name name = read_name(reading, item, fmt::format("a name of {}", what));
        const bool again = std::any_of(names.begin(), names.end(), [&](const Name& other) {
            return !name.value.empty() && other.value == name.value;
        });
        if (again) {
            reading.diagnostics.error(item.place,
                                      fmt::format("{} names '{}' twice", what, name.value));
            name.value.clear();
        }
        names.push_back(std::move(name));
    }
    if (!names.empty()) return names;
    reading.diagnostics.error(node.place, fmt::format("{} names nothing", what));
    return {Name{{}, node.place}};
}

SignedName read_signed_name(Reading& reading, const YamlNode& node, const std::string& what) {
    const char sign = node.is_scalar() && !node.text.empty() ? node.text.front() : ' ';
    if (sign != '-' && sign != '+') {
        return {read_name(reading, node, what).value, false, false, node.place};
    }
    const std::string name = node.text.substr(1);
    if (is_name(name, "-.")) {
        return {qualified(name, node.scope), sign == '-', true, node.place};
    }
    reading.diagnostics.error(node.place,
                              fmt::format("{} must be a name, not {}", what, describe(node)));
    return {{}, false, false, node.place};
}

}  // namespace hexweave
