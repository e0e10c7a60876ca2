// SPDX-License-Identifier: Apache-2.0
#include "topology/instances.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "topology/expand_entries.h"
#include "topology/includes.h"
#include "topology/instance_parameters.h"
#include "topology/instance_scope.h"
#include "topology/read_transforms.h"

namespace hexweave {

namespace {

constexpr std::size_t most_nodes = 1'000'000;  ///< of the YAML that instances stand for
constexpr std::size_t most_nested = 20;        ///< instances within instances
constexpr double similarity_tolerance = 1e-12;

/// Sections of a component whose entries become those of the case.
constexpr std::array<std::string_view, 7> sections{"curves", "surfaces", "vertices",  "edges",
                                                   "faces",  "blocks",   "boundaries"};

struct Expansion {
    Reading& reading;
    YamlNode& root;
    std::map<std::string, const YamlNode*> components;
    std::vector<std::string> open{};  ///< components that are being used, each within the last
    std::size_t nodes = 0;
    bool too_large = false;
    Instances found{};
};

std::size_t count_nodes(const YamlNode& node) {
    std::size_t count = 1;
    for (const YamlNode& child : node.children) count += count_nodes(child);
    return count;
}

YamlNode& section_for(YamlNode& root, std::string_view key) {
    for (YamlNode& child : root.children) {
        if (child.key == key && child.is_mapping()) return child;
    }
    YamlNode section;
    section.kind = YamlNode::Kind::mapping;
    section.key = key;
    root.children.push_back(std::move(section));
    return root.children.back();
}

/// The component that an instance is of; null after an error.
const YamlNode* component_of(Expansion& all, const YamlNode& instance, const std::string& what) {
    Reading& reading = all.reading;
    const YamlNode* of = require(reading, instance, "of", what);
    if (of == nullptr) return nullptr;
    const auto name = read_text(reading, *of, "'of'");
    if (!name) return nullptr;
    const auto found = all.components.find(*name);
    if (found == all.components.end()) {
        Keys known;
        for (const auto& component : all.components) known.emplace_back(component.first);
        reading.diagnostics.error(
            of->place, fmt::format("unknown component '{}'", shown(*name)),
            known.empty() ? "there are no components" : suggestion(*name, known, "components are"));
        return nullptr;
    }
    if (std::find(all.open.begin(), all.open.end(), *name) != all.open.end()) {
        reading.diagnostics.error(of->place,
                                  fmt::format("component '{}' is made of itself", shown(*name)),
                                  "take out this instance, or make it of another component");
        return nullptr;
    }
    return found->second;
}

/// Where an instance stands: one map, which keeps shapes.
void read_place_of_instance(Reading& reading, const YamlNode& instance, const std::string& what,
                            InstanceScope& scope) {
    const auto maps = read_transforms(reading, instance, what);
    if (!maps) return;
    for (const Affine& map : *maps) scope.map = compose(scope.map, map);
    const auto& rows = scope.map.rows;
    scope.scale = std::cbrt(std::abs(triple(rows[0], rows[1], rows[2])));
    const double square = scope.scale * scope.scale;
    for (std::size_t n = 0; n < 3; ++n) {
        const double stretch = std::abs(dot(rows.at(n), rows.at(n)) - square);
        const double skew = std::abs(dot(rows.at(n), rows.at((n + 1) % 3)));
        if (std::max(stretch, skew) <= similarity_tolerance * square) continue;
        reading.diagnostics.error(instance.key_place,
                                  fmt::format("{} is scaled by different factors", what),
                                  "an instance is scaled by one number, and its cells with it; "
                                  "let parameters of the component stretch its shape");
        return;
    }
}

/// The names under a key that is a name or a list of them.
std::vector<Name> names_at(Reading& reading, const YamlNode& node, const std::string& what) {
    std::vector<Name> names = read_names(reading, node, what);
    std::erase_if(names, [](const Name& name) { return name.value.empty(); });
    return names;
}

void read_ports(Expansion& all, const YamlNode& component, const ScopePointer& scope) {
    const YamlNode* ports = component.find("ports");
    if (ports == nullptr || ports->is_null()) return;
    if (!ports->is_mapping()) {
        all.reading.diagnostics.error(
            ports->place,
            fmt::format("'ports' must be a mapping of names, not {}", describe(*ports)),
            "write ports: {NAME: EDGE}");
        return;
    }
    for (const YamlNode& port : ports->children) {
        if (!check_new_name(all.reading, port, "port")) continue;
        all.found.ports[scope->prefix + port.key] =
            names_at(all.reading, port, fmt::format("port '{}'", port.key));
    }
}

/// `{to: NAME, when: EXPR}`: the node of what a port is joined to; null where it is not.
const YamlNode* joined_to(Reading& reading, const YamlNode& item) {
    if (!item.is_mapping()) return &item;
    expect_mapping(reading, item, "a join", "join");
    const YamlNode* when = find(reading, item, "when");
    if (when != nullptr && read_number(reading, *when, "'when'").value_or(0) == 0) return nullptr;
    return require(reading, item, "to", "a join");
}

void read_joins(Expansion& all, const YamlNode& instance, const std::string& what,
                const ScopePointer& scope) {
    Reading& reading = all.reading;
    const YamlNode* join = find(reading, instance, "join");
    if (join == nullptr || join->is_null()) return;
    if (!join->is_mapping()) {
        reading.diagnostics.error(
            join->place, fmt::format("'join' must be a mapping of ports, not {}", describe(*join)),
            "write join: {PORT: NAME}");
        return;
    }
    for (const YamlNode& item : join->children) {
        const auto port = all.found.ports.find(scope->prefix + item.key);
        if (port == all.found.ports.end()) {
            Keys known;
            for (const auto& [name, parts] : all.found.ports) {
                const bool own = name.compare(0, scope->prefix.size(), scope->prefix) == 0 &&
                                 name.find('.', scope->prefix.size()) == std::string::npos;
                if (own) known.emplace_back(std::string_view(name).substr(scope->prefix.size()));
            }
            reading.diagnostics.error(item.key_place,
                                      fmt::format("unknown port '{}' of {}", shown(item.key), what),
                                      known.empty() ? "its component has no ports"
                                                    : suggestion(item.key, known, "its ports are"));
            continue;
        }
        const YamlNode* to = joined_to(reading, item);
        if (to == nullptr) continue;
        all.found.joins.push_back(
            {port->first, item.key_place, port->second,
             names_at(reading, *to, fmt::format("what port '{}' is joined to", item.key))});
    }
}

void instantiate(Expansion& all, const YamlNode& instance);

/// The entries of an instance's copy of its component, under their qualified names.
void append_sections(Expansion& all, YamlNode& copy, const ScopePointer& scope) {
    for (YamlNode& section : copy.children) {
        const bool entries =
            std::find(sections.begin(), sections.end(), section.key) != sections.end();
        if (!entries || section.is_null()) continue;
        if (!section.is_mapping()) {
            all.reading.diagnostics.error(
                section.place, fmt::format("'{}' must be a mapping of names, not {}", section.key,
                                           describe(section)));
            continue;
        }
        const bool shared = section.key == "boundaries" && !scope->own_families;
        YamlNode& whole = section_for(all.root, section.key);
        for (YamlNode& entry : section.children) {
            if (!shared) entry.key = scope->prefix + entry.key;
            whole.children.push_back(std::move(entry));
        }
    }
}

bool has_room(Expansion& all, const YamlNode& instance, const YamlNode& component) {
    if (all.open.size() >= most_nested) {
        all.reading.diagnostics.error(
            instance.key_place,
            fmt::format("instances within instances are more than {} deep", most_nested),
            "make the innermost components one");
        return false;
    }
    all.nodes += count_nodes(component);
    if (all.nodes <= most_nodes) return true;
    if (!all.too_large) {
        all.reading.diagnostics.error(instance.key_place,
                                      "with this instance the case is too large",
                                      "components within components multiply");
    }
    all.too_large = true;
    return false;
}

/// The scope of an instance, registered, with its name, place and choice of families.
ScopePointer scope_of(Expansion& all, const YamlNode& instance, const std::string& what) {
    Reading& reading = all.reading;
    auto scope = std::make_shared<InstanceScope>();
    scope->outer = instance.scope;
    scope->prefix = qualified(instance.key, instance.scope) + ".";
    read_place_of_instance(reading, instance, what, *scope);
    if (const YamlNode* families = find(reading, instance, "families")) {
        const auto choice =
            read_choice(reading, *families, "'families'", words_of("instance", "families"));
        scope->own_families = choice && *choice == 1;
    }
    reading.scopes.push_back(scope);
    return scope;
}

void instantiate(Expansion& all, const YamlNode& instance) {
    Reading& reading = all.reading;
    const std::string full = qualified(instance.key, instance.scope);
    const std::string what = fmt::format("instance '{}'", shown(full));
    if (!check_new_name(reading, instance, "instance")) return;
    const YamlNode* component = expect_mapping(reading, instance, what, "instance")
                                    ? component_of(all, instance, what)
                                    : nullptr;
    if (component == nullptr || !component->is_mapping() || !has_room(all, instance, *component)) {
        reading.lost_scopes.push_back(full + ".");
        return;
    }

    const ScopePointer scope = scope_of(all, instance, what);
    YamlNode copy = *component;
    mark_used_by(copy,
                 std::make_shared<const Note>(Note{
                     instance.key_place, fmt::format("in {}, written here", what), scope->prefix}));
    set_scope(copy, scope);
    all.found.names.insert(full);
    all.found.entries.push_back(
        {{full, instance.key_place}, {component->key, component->key_place}});
    set_parameters(reading, instance, copy, what, scope, all.found.parameters);
    expand_entries(reading, copy);
    read_ports(all, copy, scope);
    read_joins(all, instance, what, scope);

    all.open.push_back(component->key);
    if (const YamlNode* inner = copy.find("instances")) {
        for (const YamlNode& other : inner->children) instantiate(all, other);
    }
    all.open.pop_back();
    append_sections(all, copy, scope);
}

}  // namespace

void reserve_sections(YamlNode& root) {
    root.children.reserve(root.children.size() + sections.size());
}

Instances expand_instances(Reading& reading, YamlNode& root) {
    Expansion all{reading, root, {}};
    if (const YamlNode* components = find(reading, root, "components")) {
        for (const YamlNode& component : components->children) {
            if (!check_new_name(reading, component, "component")) continue;
            expect_mapping(reading, component, fmt::format("component '{}'", shown(component.key)),
                           "component");
            all.components.emplace(component.key, &component);
        }
    }
    if (const YamlNode* instances = find(reading, root, "instances")) {
        const YamlNode list = *instances;
        for (const YamlNode& instance : list.children) instantiate(all, instance);
        forget_mappings(reading, root);
    }
    return std::move(all.found);
}

}  // namespace hexweave
