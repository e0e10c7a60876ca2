// SPDX-License-Identifier: Apache-2.0
#include "topology/read_case.h"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include "topology/expand_entries.h"
#include "topology/includes.h"
#include "topology/instances.h"
#include "topology/join_ports.h"
#include "topology/overrides.h"
#include "topology/place_instances.h"
#include "topology/read_entries.h"
#include "topology/read_gates.h"
#include "topology/read_levels.h"
#include "topology/read_output.h"
#include "topology/read_parameters.h"
#include "topology/read_periodic.h"
#include "topology/read_sweep.h"
#include "topology/read_values.h"
#include "topology/shapes.h"
#include "topology/yaml_tree.h"

namespace hexweave {

namespace {

/// [Fowler, Noll & Vo], 64 bits: enough to tell one config from another.
std::uint64_t fnv1a64(const std::string& text) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    return hash;
}

std::string provenance_of(const Reading& reading, const std::vector<Override>& overrides) {
    std::string text = fmt::format("hexweave {}; config fnv1a64:{:016x}", HEXWEAVE_VERSION,
                                   fnv1a64(reading.source->text));
    for (const auto& file : reading.included) {
        text += fmt::format("; include fnv1a64:{:016x}", fnv1a64(file->text));
    }
    for (const Override& o : overrides) text += fmt::format("; set {}={}", o.name, o.expression);
    return text;
}

/// A section that is a mapping of names; null where there is none or it is empty.
const YamlNode* section_of(Reading& reading, const YamlNode& root, std::string_view key) {
    const YamlNode* section = find(reading, root, key);
    if (section == nullptr || section->is_null() || section->is_mapping()) {
        return section != nullptr && section->is_mapping() ? section : nullptr;
    }
    reading.diagnostics.error(
        section->place,
        fmt::format("'{}' must be a mapping of names, not {}", key, describe(*section)),
        usage_of(reading, *section));
    reading.lost_sections.emplace_back(key);
    return nullptr;
}

/// Entries in a list, each behind a '- ', are told once and read all the same.
void join_listed_entries(Reading& reading, YamlNode& root) {
    for (YamlNode& section : root.children) {
        if (!section.is_sequence() || !holds_entries(section.key)) continue;
        std::vector<YamlNode> entries;
        for (YamlNode& item : section.children) {
            if (!item.is_mapping()) break;
            std::move(item.children.begin(), item.children.end(), std::back_inserter(entries));
        }
        if (entries.size() < section.children.size() || entries.empty()) continue;
        reading.diagnostics.error(
            section.place, fmt::format("'{}' must be a mapping of names, not a list", section.key),
            fmt::format("write its entries without '- ', each as '{}: ...'",
                        shown(entries.front().key)));
        section.kind = YamlNode::Kind::mapping;
        section.children = std::move(entries);
    }
}

void read_title_and_units(Reading& reading, const YamlNode& root, Case& c) {
    if (const YamlNode* title = find(reading, root, "title")) {
        c.title = read_text(reading, *title, "'title'").value_or("");
    }
    if (const YamlNode* units = find(reading, root, "units")) {
        const Keys& known = words_of("case", "units");
        const auto choice = read_choice(reading, *units, "'units'", known);
        if (choice) c.units = known[*choice];
    }
}

void read_solver(Reading& reading, const YamlNode& root, SolverEntry& solver) {
    const YamlNode* node = section_of(reading, root, "solver");
    if (node == nullptr) return;
    expect_mapping(reading, *node, "'solver'", "solver");
    if (const YamlNode* tolerance = find(reading, *node, "tolerance")) {
        solver.tolerance =
            read_positive(reading, *tolerance, "'tolerance'").value_or(solver.tolerance);
    }
    if (const YamlNode* maximum = find(reading, *node, "maximum_cycles")) {
        solver.maximum_cycles =
            read_count(reading, *maximum, "'maximum_cycles'").value_or(solver.maximum_cycles);
    }
    if (const YamlNode* start = find(reading, *node, "start")) {
        const auto choice = read_choice(reading, *start, "'start'", words_of("solver", "start"));
        solver.start_folded = choice && *choice == 1;
    }
    solver.flat_edge_exponent = read_flat_edge_exponent(reading, *node);
}

/// Those of instances are recorded under their qualified names.
void append_parameters(std::vector<Parameter>& parameters,
                       const std::vector<InstanceParameter>& of_instances) {
    for (const InstanceParameter& p : of_instances) {
        parameters.push_back({{p.scope->prefix + p.name, p.place}, p.value, p.overridden});
    }
}

template <class Entry>
void read_into(std::vector<Entry>& entries, Reading& reading, const YamlNode& root,
               std::string_view key, std::vector<Entry> (*read)(Reading&, const YamlNode&)) {
    const YamlNode* section = section_of(reading, root, key);
    if (section != nullptr) entries = read(reading, *section);
}

}  // namespace

Case read_case(const std::shared_ptr<const SourceFile>& source,
               const std::vector<Override>& overrides, Diagnostics& diagnostics) {
    Case c;
    c.source = source;
    Reading reading{diagnostics, source};
    c.provenance = provenance_of(reading, overrides);
    std::optional<YamlNode> root = read_yaml(source, diagnostics);
    if (!root) return c;
    if (!root->is_mapping()) {
        diagnostics.error(root->place,
                          fmt::format("a case must be a mapping, not {}", describe(*root)),
                          "it begins with 'hexweave: 1'");
        return c;
    }
    if (!check_version(reading, *root)) return c;
    note_overrides(reading, overrides);
    root = merge_includes(reading, std::move(*root));
    c.provenance = provenance_of(reading, overrides);
    reserve_sections(*root);
    expect_mapping(reading, *root, "a case", "case");
    join_listed_entries(reading, *root);
    read_title_and_units(reading, *root, c);
    reading.units = c.units;
    c.parameters = read_parameters(reading, section_of(reading, *root, "parameters"));
    expand_entries(reading, *root);
    const Instances instances = expand_instances(reading, *root);
    c.instances = instances.entries;
    tell_unknown_overrides(reading, c.parameters, instances);
    const YamlNode* curves = section_of(reading, *root, "curves");
    read_shapes(reading, curves, section_of(reading, *root, "surfaces"), c);
    read_into(c.vertices, reading, *root, "vertices", read_vertices);
    read_into(c.edges, reading, *root, "edges", read_edges);
    read_into(c.faces, reading, *root, "faces", read_faces);
    read_into(c.blocks, reading, *root, "blocks", read_blocks);
    read_into(c.boundaries, reading, *root, "boundaries", read_boundaries);
    read_into(c.periodic, reading, *root, "periodic", read_periodic);
    place_instances(reading, *root, c);
    c.left_out = std::move(reading.left_out);
    join_ports(c, instances, diagnostics);
    merge_families(c, diagnostics);
    read_sweep_and_mirror(reading, *root, c);
    read_levels(reading, *root, c);
    c.multiple_of = read_multiple_of(reading, *root);
    read_solver(reading, *root, c.solver);
    c.outputs = read_output(reading, section_of(reading, *root, "output"));
    c.gates = read_gates(reading, *root);
    if (!diagnostics.has_errors()) {
        warn_unused_parameters(reading, c.parameters, instances.parameters);
    }
    append_parameters(c.parameters, instances.parameters);
    c.files = std::move(reading.files);
    c.lost_sections = std::move(reading.lost_sections);
    c.lost_scopes = std::move(reading.lost_scopes);
    return c;
}

}  // namespace hexweave
