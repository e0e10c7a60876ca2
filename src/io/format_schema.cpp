// SPDX-License-Identifier: Apache-2.0
#include "io/format_schema.h"

#include <cmath>
#include <memory>

#include "io/format_words.h"
#include "io/json_values.h"
#include "topology/format_table.h"
#include "topology/yaml_tree.h"

namespace hexweave {
namespace {

using Kind = ValueForm::Kind;

// Words that YAML 1.1 reads as truth values are no names; a reader of YAML 1.2 hands them on.
constexpr const char* no_switch =
    "^([yY]|[nN]|[yY][eE][sS]|[nN][oO]|[oO][nN]|[oO][fF][fF]|true|false|null)$";
/// With the index of a repetition in braces: passage{i - 1}.
constexpr const char* name_pattern = R"(^[A-Za-z_]([A-Za-z0-9_]|\{[^{}]+\})*$)";
/// A name in a component is qualified, a made edge or face is named after its corners.
constexpr const char* use_pattern = R"(^[A-Za-z_]([A-Za-z0-9_.-]|\{[^{}]+\})*$)";
constexpr const char* signed_pattern = R"(^[-+]?[A-Za-z_]([A-Za-z0-9_.-]|\{[^{}]+\})*$)";
/// What an expression is written with; a comma stands between arguments only.
constexpr const char* expression_pattern =
    R"(^\s*[-+*/^().\w\s<>=!&|?:]+\s*$|^[^,]*\([-+*/^().,\w\s<>=!&|?:]*\s*$)";

Json reference(std::string_view definition) {
    return {{"$ref", "#/$defs/" + std::string(definition)}};
}

/// A text as JSON where it is a literal of it: 1e-3, true, [0, 0, 1]; else the text itself.
Json literal(const std::string& text) {
    return Json::accept(text) ? Json::parse(text) : Json(text);
}

Json value_of(const YamlNode& node) {
    switch (node.kind) {
        case YamlNode::Kind::null:
            return nullptr;
        case YamlNode::Kind::scalar:
            return node.quoted ? Json(node.text) : literal(node.text);
        case YamlNode::Kind::sequence:
            return json_list(node.children, value_of);
        case YamlNode::Kind::mapping:
            break;
    }
    Json object = Json::object();
    for (const YamlNode& child : node.children) object[child.key] = value_of(child);
    return object;
}

/// The value of the key in its example.
Json example_of(const KeyFormat& key) {
    Diagnostics diagnostics;
    const auto source = std::make_shared<const SourceFile>(
        SourceFile{"example", "{" + std::string(key.example) + "}"});
    const auto root = read_yaml(source, diagnostics);
    const YamlNode* value = root ? root->find(key.key) : nullptr;
    return value == nullptr ? Json(nullptr) : value_of(*value);
}

/// A literal within the limits, or an expression: its value is known when it is evaluated.
Json number_schema(const Limits& limits) {
    Json number{{"type", "number"}};
    if (std::isfinite(limits.above)) number["exclusiveMinimum"] = limits.above;
    if (std::isfinite(limits.at_least)) number["minimum"] = limits.at_least;
    if (std::isfinite(limits.at_most)) number["maximum"] = limits.at_most;
    if (std::isfinite(limits.below)) number["exclusiveMaximum"] = limits.below;
    return {{"anyOf", {number, reference("an_expression")}}};
}

/// Words; those that are numbers may be written as such.
Json words_schema(const Keys& words) {
    Json list = Json::array();
    for (const std::string_view word : words) {
        list.push_back(std::string(word));
        if (const Json value = literal(std::string(word)); value.is_number()) list.push_back(value);
    }
    return {{"enum", list}};
}

Json values_schema(const std::vector<ValueForm>& forms);

Json list_schema(const ValueForm& form) {
    Json schema{{"type", "array"}, {"items", values_schema(form.items)}};
    if (form.least > 0) schema["minItems"] = form.least;
    if (form.most > 0) schema["maxItems"] = form.most;
    return schema;
}

Json entries_schema(const ValueForm& form) {
    Json names{{"pattern", name_pattern}, {"not", {{"pattern", no_switch}}}};
    if (form.most > 0) names["maxLength"] = form.most;
    Json schema{{"type", "object"}, {"propertyNames", names}};
    schema["additionalProperties"] = form.items.empty() ? Json(false) : values_schema(form.items);
    return schema;
}

Json value_schema(const ValueForm& form) {
    switch (form.kind) {
        case Kind::number:
            return number_schema(form.limits);
        case Kind::count:
            return reference("a_count");
        case Kind::point:
            return reference("a_point");
        case Kind::formula:
            return reference("a_formula");
        case Kind::text:
            return reference("a_text");
        case Kind::file:
            return {{"type", "string"}, {"minLength", 1}};
        case Kind::truth:
            return {{"type", "boolean"}};
        case Kind::words:
            return words_schema(form.words);
        case Kind::name:
            return reference("a_name");
        case Kind::signed_name:
            return reference("a_signed_name");
        case Kind::axis_plane:
            return {{"type", "string"}, {"pattern", R"(^\s*[xyz]\s*=\s*\S)"}};
        case Kind::list:
            return list_schema(form);
        case Kind::mapping:
            return reference(form.of);
        case Kind::entries:
            break;
    }
    return entries_schema(form);
}

Json values_schema(const std::vector<ValueForm>& forms) {
    if (forms.size() == 1) return value_schema(forms.front());
    return {{"anyOf", json_list(forms, value_schema)}};
}

Json key_schema(const KeyFormat& key) {
    Json schema = values_schema(key.values);
    // Beside a reference other keywords hold as well, since 2019-09.
    schema["description"] = description_of(key);
    if (has_literal_default(key)) schema["default"] = literal(std::string(key.absent));
    schema["examples"] = Json::array({example_of(key)});
    return schema;
}

void add_properties(Json& properties, const MappingFormat& format) {
    for (const KeyFormat& key : format.keys) {
        const std::string name(key.key);
        if (!properties.contains(name)) properties[name] = key_schema(key);
    }
}

/// Of each choice exactly one key.
Json choices_schema(const std::vector<Keys>& choices) {
    return json_list(choices, [](const Keys& choice) {
        return Json{{"oneOf", json_list(choice, [](std::string_view key) {
                         return Json{{"required", {std::string(key)}}};
                     })}};
    });
}

Json mapping_schema(const MappingFormat& format) {
    Json properties = Json::object();
    add_properties(properties, format);
    for (const std::string_view other : format.with) {
        if (const MappingFormat* more = find_format(other)) add_properties(properties, *more);
    }
    Json schema{{"type", "object"},
                {"description", std::string(format.what)},
                {"properties", properties},
                {"additionalProperties", false}};
    const Keys required = required_keys(format.name);
    if (!required.empty()) schema["required"] = required;
    if (!format.one_of.empty()) schema["allOf"] = choices_schema(format.one_of);
    return schema;
}

/// What values of several keys are.
Json value_definitions() {
    const Json not_a_switch{{"pattern", no_switch}};
    const auto name = [&](const char* pattern, const char* what) {
        return Json{
            {"description", what}, {"type", "string"}, {"pattern", pattern}, {"not", not_a_switch}};
    };
    return {
        {"an_expression",
         {{"description", "An expression in numbers and parameters, as in 20 * chord."},
          {"type", "string"},
          {"pattern", expression_pattern}}},
        {"a_count",
         {{"description", "A whole number from 1 on, or an expression."},
          {"anyOf", {{{"type", "integer"}, {"minimum", 1}}, reference("an_expression")}}}},
        {"a_point",
         {{"description", "[x, y] or [x, y, z]."},
          {"type", "array"},
          {"items", number_schema({})},
          {"minItems", 2},
          {"maxItems", 3}}},
        {"a_formula",
         {{"description", "An expression in the variables of the curve, surface or edge."},
          {"anyOf", {{{"type", "number"}}, reference("an_expression")}}}},
        {"a_text",
         {{"description", "A text; one that is a number need not be quoted."},
          {"anyOf", {{{"type", "string"}, {"minLength", 1}}, {{"type", "number"}}}}}},
        {"a_name", name(use_pattern, "A name that another entry has, or a-b after its corners.")},
        {"a_signed_name", name(signed_pattern, "A name; -NAME is the same backwards.")}};
}

}  // namespace

std::string format_schema() {
    const MappingFormat& whole = format_table().front();
    Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                {"title", "hexweave case, version 1 of the format"}};
    schema.update(mapping_schema(whole));
    Json definitions = value_definitions();
    for (const MappingFormat& format : format_table()) {
        if (&format != &whole) definitions[std::string(format.name)] = mapping_schema(format);
    }
    schema["$defs"] = definitions;
    return schema.dump(2) + "\n";
}

}  // namespace hexweave
