// SPDX-License-Identifier: Apache-2.0
#include "topology/read_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

#include "topology/instance_scope.h"

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

/// The names in a text.
std::vector<std::string> names_in(const std::string& text) {
    static constexpr std::string_view letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
    std::vector<std::string> names;
    for (std::size_t begin = text.find_first_of(letters); begin != std::string::npos;) {
        const std::size_t end = std::min(text.find_first_not_of(letters, begin), text.size());
        names.push_back(text.substr(begin, end - begin));
        begin = text.find_first_of(letters, end);
    }
    return names;
}

/// The parameters of a section as they are computed: in order; but one that an include gives a
/// value waits for what that value needs, which may stand further down.
class ParameterTable {
public:
    ParameterTable(Reading& reading, const YamlNode& section,
                   const std::vector<Override>& overrides)
        : reading_(reading),
          section_(section),
          overrides_(overrides_by_name(reading, &section, overrides)),
          states_(section.children.size(), State::waiting),
          parameters_(section.children.size()) {
        for (std::size_t n = 0; n < section.children.size(); ++n) {
            reading.parameters.later.insert(section.children[n].key);
            index_.emplace(section.children[n].key, n);
        }
    }

    std::vector<Parameter> compute() {
        for (std::size_t n = 0; n < states_.size(); ++n) compute(n, 0);
        return std::move(parameters_);
    }

private:
    enum class State { waiting, begun };
    static constexpr int longest_chain = 1000;  ///< of parameters that wait for one another

    /// What stands for the parameter's own expression; null where nothing does.
    const YamlNode* replacement(const YamlNode& node, bool& from_include) const {
        const auto given = overrides_.find(node.key);
        if (given != overrides_.end()) return &given->second;
        const auto set = reading_.replaced.find(node.key);
        from_include = set != reading_.replaced.end();
        return from_include ? &set->second : nullptr;
    }

    void compute(std::size_t n, int chain) {
        if (states_[n] == State::begun || chain > longest_chain) return;
        states_[n] = State::begun;
        const YamlNode& node = section_.children[n];
        bool from_include = false;
        const YamlNode* other = replacement(node, from_include);
        const YamlNode& value = other != nullptr ? *other : node;
        for (const std::string& name : names_in(value.text)) {
            const auto needed = index_.find(name);
            if (needed == index_.end()) continue;
            if (from_include || needed->second < n) compute(needed->second, chain + 1);
        }
        check_parameter_name(reading_, node);
        ParameterScope& scope = reading_.parameters;
        // What the replaced expression used counts as used; its value does not matter.
        if (other != nullptr && node.is_scalar()) evaluate(node.text, scope);
        const auto number =
            read_number(reading_, value, fmt::format("parameter '{}'", shown(node.key)));
        scope.values[node.key] = number;
        scope.later.erase(node.key);
        parameters_[n] = {{node.key, node.key_place}, number.value_or(0), other != nullptr};
    }

    Reading& reading_;
    const YamlNode& section_;
    std::map<std::string, YamlNode> overrides_;
    std::vector<State> states_;
    std::vector<Parameter> parameters_;
    std::map<std::string, std::size_t> index_;
};

}  // namespace

void check_parameter_name(Reading& reading, const YamlNode& node) {
    if (!check_new_name(reading, node, "parameter")) return;
    if (!is_reserved_in_expressions(node.key)) return;
    reading.diagnostics.error(node.key_place,
                              fmt::format("'{}' is not a valid parameter name", node.key),
                              "it is a function or a constant of expressions");
}

std::vector<Parameter> read_parameters(Reading& reading, const YamlNode* section,
                                       const std::vector<Override>& overrides) {
    if (section != nullptr) return ParameterTable(reading, *section, overrides).compute();
    overrides_by_name(reading, section, overrides);
    return {};
}

void warn_unused_parameters(Reading& reading, const std::vector<Parameter>& parameters) {
    for (auto scope = reading.scopes.rbegin(); scope != reading.scopes.rend(); ++scope) {
        if (!(*scope)->repeats) continue;
        const ScopePointer& outer = (*scope)->outer;
        (outer ? outer->parameters : reading.parameters).used.merge((*scope)->parameters.used);
    }
    for (const Parameter& p : parameters) {
        if (p.overridden || reading.parameters.used.contains(p.name.value)) continue;
        reading.diagnostics.warning(p.name.place,
                                    fmt::format("parameter '{}' is never used", p.name.value));
    }
}

}  // namespace hexweave
