// SPDX-License-Identifier: Apache-2.0
#include "topology/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <utility>

namespace hexweave {

namespace {

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

Keys keys_of(const std::set<std::string>& names) {
    return {names.begin(), names.end()};
}

/// For a name that the case does not know but an instance does.
std::string hint_for(const std::string& name, const std::set<std::string>& known,
                     const Instances& instances) {
    for (const InstanceParameter& p : instances.parameters) {
        if (p.name != name) continue;
        return fmt::format("did you mean '{}'? parameters of instances are set by their full names",
                           p.scope->prefix + name);
    }
    return known.empty() ? "the file has no parameters"
                         : suggestion(name, keys_of(known), "parameters are");
}

void tell_unknown_of_instance(Reading& reading, const YamlNode& given, const Instances& instances) {
    const std::size_t dot = given.key.rfind('.');
    const std::string prefix = given.key.substr(0, dot);
    const std::string name = given.key.substr(dot + 1);
    std::set<std::string> known;
    for (const InstanceParameter& p : instances.parameters) {
        if (p.scope->prefix == prefix + ".") known.insert(p.name);
    }
    if (!instances.names.contains(prefix)) {
        const Keys names = keys_of(instances.names);
        reading.diagnostics.error(
            given.key_place,
            fmt::format("'{}' is a parameter of no instance: there is no instance '{}'",
                        shown(given.key), shown(prefix)),
            names.empty() ? "the file has no instances"
                          : suggestion(prefix, names, "instances are"));
        return;
    }
    reading.diagnostics.error(
        given.key_place,
        fmt::format("unknown parameter '{}' of instance '{}'", shown(name), shown(prefix)),
        known.empty() ? "its component has no parameters"
                      : suggestion(name, keys_of(known), "its parameters are"));
}

}  // namespace

void note_overrides(Reading& reading, const std::vector<Override>& overrides) {
    for (const Override& given : overrides) {
        const YamlNode node = override_node(given);
        if (reading.overrides.emplace(given.name, node).second) continue;
        reading.diagnostics.error(node.key_place,
                                  fmt::format("the parameter '{}' is set twice", given.name),
                                  "leave one out");
    }
}

void tell_unknown_overrides(Reading& reading, const std::vector<Parameter>& parameters,
                            const Instances& instances) {
    std::set<std::string> known;
    for (const Parameter& p : parameters) known.insert(p.name.value);
    std::set<std::string> of_instances;
    for (const InstanceParameter& p : instances.parameters) {
        of_instances.insert(p.scope->prefix + p.name);
    }
    const bool sound = !reading.diagnostics.has_errors();
    for (const auto& [name, node] : reading.overrides) {
        if (name.find('.') != std::string::npos) {
            if (sound && !of_instances.contains(name)) {
                tell_unknown_of_instance(reading, node, instances);
            }
        } else if (!known.contains(name)) {
            reading.diagnostics.error(node.key_place,
                                      fmt::format("unknown parameter '{}'", shown(name)),
                                      hint_for(name, known, instances));
        }
    }
}

}  // namespace hexweave
