// SPDX-License-Identifier: Apache-2.0
#include "topology/instance_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "topology/read_parameters.h"

namespace hexweave {

namespace {

/// The values that an instance's `set` gives; null after an error, or where it gives none. Tells
/// parameters that its component has not.
const YamlNode* read_set(Reading& reading, const YamlNode& instance, const YamlNode* declared,
                         const std::string& what) {
    const YamlNode* set = find(reading, instance, "set");
    if (set == nullptr) return nullptr;
    if (!set->is_mapping()) {
        reading.diagnostics.error(
            set->place,
            fmt::format("'set' must be a mapping of parameters, not {}", describe(*set)),
            usage_of(reading, *set));
        return nullptr;
    }
    Keys known;
    if (declared != nullptr) {
        for (const YamlNode& node : declared->children) known.emplace_back(node.key);
    }
    for (const YamlNode& value : set->children) {
        if (std::find(known.begin(), known.end(), value.key) != known.end()) continue;
        reading.diagnostics.error(
            value.key_place, fmt::format("unknown parameter '{}' of {}", shown(value.key), what),
            known.empty() ? "its component has no parameters"
                          : suggestion(value.key, known, "its parameters are"));
    }
    return set;
}

/// What gives a parameter its value; null, after an error, where nothing does. What a replaced
/// expression used counts as used.
const YamlNode* value_of(Reading& reading, const YamlNode& instance, const YamlNode& declared,
                         const YamlNode* set, const ScopePointer& scope, const std::string& what) {
    const auto overridden = reading.overrides.find(scope->prefix + declared.key);
    const YamlNode* given = set == nullptr ? nullptr : set->find(declared.key);
    const bool required = declared.is_scalar() && declared.text == "required";
    if (given == nullptr && overridden == reading.overrides.end() && required) {
        Diagnostic& d = reading.diagnostics.error(
            instance.key_place, fmt::format("{} must set the parameter '{}'", what, declared.key),
            fmt::format("write set: {{{}: ...}}", declared.key));
        d.notes.push_back({declared.key_place, "it has no default"});
        return nullptr;
    }
    const auto replace = [&](const YamlNode& node) {
        if (node.is_scalar()) evaluate(node.text, parameters_at(reading, node));
    };
    if (overridden == reading.overrides.end() && given == nullptr) return &declared;
    if (!required) replace(declared);
    if (overridden == reading.overrides.end()) return given;
    if (given != nullptr) replace(*given);
    return &overridden->second;
}

}  // namespace

void set_parameters(Reading& reading, const YamlNode& instance, const YamlNode& component,
                    const std::string& what, const ScopePointer& scope,
                    std::vector<InstanceParameter>& parameters) {
    const YamlNode* section = component.find("parameters");
    const YamlNode* set = read_set(reading, instance, section, what);
    if (section == nullptr) return;
    for (const YamlNode& node : section->children) scope->parameters.later.insert(node.key);
    for (const YamlNode& node : section->children) {
        check_parameter_name(reading, node);
        const YamlNode* value = value_of(reading, instance, node, set, scope, what);
        std::optional<double> number;
        if (value != nullptr) {
            number = read_number(reading, *value, fmt::format("parameter '{}'", shown(node.key)));
        }
        scope->parameters.values[node.key] = number;
        scope->parameters.later.erase(node.key);
        Place place = node.key_place;
        place.used_by = nullptr;
        const bool overridden = reading.overrides.contains(scope->prefix + node.key);
        parameters.push_back(
            {scope, component.key, node.key, number.value_or(0), overridden, place});
    }
}

}  // namespace hexweave
