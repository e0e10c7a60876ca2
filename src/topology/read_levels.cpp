// SPDX-License-Identifier: Apache-2.0
#include "topology/read_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "topology/levels.h"
#include "topology/names.h"

namespace hexweave {

namespace {

constexpr std::size_t most_levels = 8;
constexpr double greatest_factor = 4;

void read_factor(Reading& reading, const YamlNode& node, LevelsEntry& levels) {
    const auto factor = read_number(reading, node, "'factor'");
    if (!factor) return;
    if (*factor > 1 && *factor <= greatest_factor) {
        levels.factor = *factor;
        return;
    }
    reading.diagnostics.error(
        node.place,
        fmt::format("'factor' must be above 1 and at most {:g}, not {:g}", greatest_factor,
                    *factor),
        "it multiplies the cells along every edge, from one level to the next");
}

/// What is wrong with the names of levels; empty when nothing is.
std::string fault_of(const std::vector<Name>& names) {
    const auto named = [&](const char* text) {
        return std::any_of(names.begin(), names.end(),
                           [&](const Name& name) { return name.value == text; });
    };
    if (names.size() < 2 || names.size() > most_levels) {
        return fmt::format("'names' must be 2 to {} levels, not {}", most_levels, names.size());
    }
    if (!named(middle_level)) return "none of 'names' is 'medium', whose counts stand in the file";
    if (named(every_level)) return "no level can be named 'all': that stands for every level";
    return {};
}

/// False where they are faulty.
bool read_level_names(Reading& reading, const YamlNode& node, LevelsEntry& levels) {
    const std::vector<Name> names = read_names(reading, node, "'names'");
    if (std::any_of(names.begin(), names.end(), [](const Name& n) { return n.value.empty(); })) {
        return false;
    }
    const std::string fault = fault_of(names);
    if (!fault.empty()) {
        reading.diagnostics.error(node.place, fault,
                                  "write them coarsest first: names: [coarse, medium, fine]");
        return false;
    }
    levels.names.clear();
    for (const Name& name : names) levels.names.push_back(name.value);
    return true;
}

void read_level(Reading& reading, const YamlNode& node, Case& c) {
    const Name name = read_name(reading, node, "'level'");
    if (name.value.empty()) return;
    const std::vector<std::string>& known = c.levels.names;
    if (std::find(known.begin(), known.end(), name.value) != known.end()) {
        c.level = name;
        return;
    }
    reading.diagnostics.error(name.place, fmt::format("unknown level {}", quoted(name.value)),
                              suggestion(name.value, {known.begin(), known.end()}, "levels are"));
}

}  // namespace

void read_levels(Reading& reading, const YamlNode& root, Case& c) {
    bool names_known = true;
    const YamlNode* levels = find(reading, root, "levels");
    if (levels != nullptr) names_known = expect_mapping(reading, *levels, "'levels'", "levels");
    if (levels != nullptr && names_known) {
        c.levels.place = levels->key_place;
        if (const YamlNode* factor = find(reading, *levels, "factor")) {
            read_factor(reading, *factor, c.levels);
        }
        if (const YamlNode* names = find(reading, *levels, "names")) {
            names_known = read_level_names(reading, *names, c.levels);
        }
    }
    const YamlNode* level = find(reading, root, "level");
    if (level != nullptr && names_known) read_level(reading, *level, c);
}

}  // namespace hexweave
