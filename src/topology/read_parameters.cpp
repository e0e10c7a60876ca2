// SPDX-License-Identifier: Apache-2.0
#include "topology/read_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace hexweave {

namespace {

/// An override as a node of its own source, so that its faults show the argument.
YamlNode override_node(const Override& given) {
    const std::string text = given.name + "=" + given.expression;
    YamlNode node;
    node.kind = YamlNode::Kind::scalar;
    node.text = given.expression;
    node.key = given.name;
    const auto source = std::make_shared<const SourceFile>(SourceFile{"--set", text});
    const int name_length = std::max(1, static_cast<int>(given.name.size()));
    const int value_length = std::max(1, static_cast<int>(given.expression.size()));
    node.key_place = {source, 1, 1, name_length};
    node.place = {source, 1, static_cast<int>(given.name.size()) + 2, value_length};
    node.text_column = node.place.column;
    return node;
}

/// The overrides by name; tells those of unknown names and those given twice.
std::map<std::string, YamlNode> overrides_by_name(Reading& reading, const YamlNode* section,
                                                  const std::vector<Override>& overrides) {
    Keys known;
    if (section != nullptr) {
        for (const YamlNode& child : section->children) known.emplace_back(child.key);
    }
    std::map<std::string, YamlNode> by_name;
    for (const Override& given : overrides) {
        YamlNode node = override_node(given);
        if (std::find(known.begin(), known.end(), given.name) == known.end()) {
            reading.diagnostics.error(
                node.key_place, fmt::format("unknown parameter '{}'", shown(given.name)),
                known.empty() ? "the file has no parameters"
                              : suggestion(given.name, known, "parameters are"));
        } else if (!by_name.emplace(given.name, node).second) {
            reading.diagnostics.error(node.key_place,
                                      fmt::format("the parameter '{}' is set twice", given.name));
        }
    }
    return by_name;
}

void check_parameter_name(Reading& reading, const YamlNode& node) {
    if (!check_new_name(reading, node, "parameter")) return;
    if (!is_reserved_in_expressions(node.key)) return;
    reading.diagnostics.error(node.key_place,
                              fmt::format("'{}' is not a valid parameter name", node.key),
                              "it is a function or a constant of expressions");
}

}  // namespace

std::vector<Parameter> read_parameters(Reading& reading, const YamlNode* section,
                                       const std::vector<Override>& overrides) {
    const std::map<std::string, YamlNode> given = overrides_by_name(reading, section, overrides);
    std::vector<Parameter> parameters;
    if (section == nullptr) return parameters;
    ParameterScope& scope = reading.parameters;
    for (const YamlNode& node : section->children) scope.later.insert(node.key);

    for (const YamlNode& node : section->children) {
        check_parameter_name(reading, node);
        const auto found = given.find(node.key);
        const bool overridden = found != given.end();
        // What the replaced expression used counts as used; its value does not matter.
        if (overridden && node.is_scalar()) evaluate(node.text, scope);
        const auto value = read_number(reading, overridden ? found->second : node,
                                       fmt::format("parameter '{}'", shown(node.key)));
        scope.values[node.key] = value;
        scope.later.erase(node.key);
        parameters.push_back({{node.key, node.key_place}, value.value_or(0), overridden});
    }
    return parameters;
}

void warn_unused_parameters(Reading& reading, const std::vector<Parameter>& parameters) {
    for (const Parameter& p : parameters) {
        if (p.overridden || reading.parameters.used.contains(p.name.value)) continue;
        reading.diagnostics.warning(p.name.place,
                                    fmt::format("parameter '{}' is never used", p.name.value));
    }
}

}  // namespace hexweave
