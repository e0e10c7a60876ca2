// SPDX-License-Identifier: Apache-2.0
#include "topology/read_parameters.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <utility>

#include "topology/instance_scope.h"

namespace hexweave {

namespace {

/// The parameters of a section as they are computed: in order; but one that an include gives a
/// value waits for what that value needs, which may stand further down.
class ParameterTable {
public:
    ParameterTable(Reading& reading, const YamlNode& section)
        : reading_(reading),
          section_(section),
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
        const auto given = reading_.overrides.find(node.key);
        if (given != reading_.overrides.end()) return &given->second;
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
                              fmt::format("it is a function or a constant of expressions; "
                                          "'{}_' would do",
                                          node.key));
}

std::vector<Parameter> read_parameters(Reading& reading, const YamlNode* section) {
    return section == nullptr ? std::vector<Parameter>{}
                              : ParameterTable(reading, *section).compute();
}

namespace {

/// What repeated entries use, the scopes use that these stand in.
void pass_on_uses(Reading& reading) {
    for (auto scope = reading.scopes.rbegin(); scope != reading.scopes.rend(); ++scope) {
        if (!(*scope)->repeats) continue;
        const ScopePointer& outer = (*scope)->outer;
        (outer ? outer->parameters : reading.parameters).used.merge((*scope)->parameters.used);
    }
}

/// A parameter of a component counts as used where one instance uses it.
void warn_unused_in_components(Reading& reading, const std::vector<InstanceParameter>& parameters) {
    std::map<std::pair<std::string, std::string>, const InstanceParameter*> unused;
    std::set<std::pair<std::string, std::string>> used;
    for (const InstanceParameter& p : parameters) {
        const std::pair key{p.component, p.name};
        if (p.overridden || p.scope->parameters.used.contains(p.name)) used.insert(key);
        unused.emplace(key, &p);
    }
    for (const auto& [key, p] : unused) {
        if (used.contains(key)) continue;
        reading.diagnostics.warning(
            p->place,
            fmt::format("parameter '{}' of component '{}' is never used", p->name, p->component));
    }
}

}  // namespace

void warn_unused_parameters(Reading& reading, const std::vector<Parameter>& parameters,
                            const std::vector<InstanceParameter>& of_instances) {
    pass_on_uses(reading);
    for (const Parameter& p : parameters) {
        if (p.overridden || reading.parameters.used.contains(p.name.value)) continue;
        reading.diagnostics.warning(p.name.place,
                                    fmt::format("parameter '{}' is never used", p.name.value),
                                    "use it in an expression, or leave it out");
    }
    warn_unused_in_components(reading, of_instances);
}

}  // namespace hexweave
