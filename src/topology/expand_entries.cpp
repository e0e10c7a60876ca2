// SPDX-License-Identifier: Apache-2.0
#include "topology/expand_entries.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "topology/instance_scope.h"

namespace hexweave {

namespace {

constexpr int most_repeated = 100'000;  ///< entries that repetition may make of a case
constexpr double largest_index = 1e6;

/// What an entry that is left out would use is not told to be unused.
void count_as_used(Reading& reading, const YamlNode& node) {
    if (node.is_scalar()) {
        for (const std::string& name : names_in(node.text)) {
            parameters_at(reading, node).used.insert(name);
        }
    }
    for (const YamlNode& child : node.children) count_as_used(reading, child);
}

bool is_wanted(Reading& reading, const YamlNode& entry, const std::string& section) {
    const YamlNode* when = entry.is_mapping() ? entry.find("when") : nullptr;
    if (when == nullptr || read_number(reading, *when, "'when'").value_or(0) != 0) return true;
    count_as_used(reading, entry);
    reading.left_out.push_back({section, qualified(entry.key, entry.scope), when->place});
    return false;
}

std::optional<int> read_whole(Reading& reading, const YamlNode& node, const std::string& what) {
    const std::optional<double> value = read_number(reading, node, what);
    if (!value) return std::nullopt;
    if (*value == std::round(*value) && std::abs(*value) <= largest_index) {
        return static_cast<int>(*value);
    }
    reading.diagnostics.error(
        node.place,
        fmt::format("{} must be a whole number of at most {}, not {}", what, largest_index, *value),
        "as in repeat: {i: [1, 5]}, blade{i} and blade{i + 1}");
    return std::nullopt;
}

struct Index {
    std::string name;
    int first = 0;
    int last = 0;
};

/// `i: [1, 5]`. A range may be empty, [1, 0], but not run backwards.
std::optional<Index> read_index(Reading& reading, const YamlNode& node) {
    if (!check_new_name(reading, node, "index")) return std::nullopt;
    const ParameterScope& known = parameters_at(reading, node);
    if (known.values.contains(node.key) || is_reserved_in_expressions(node.key)) {
        reading.diagnostics.error(
            node.key_place, fmt::format("'{}' means something already", node.key),
            "an index needs a name that no parameter, function or other index has");
        return std::nullopt;
    }
    const std::string what = fmt::format("the index '{}'", node.key);
    if (!node.is_sequence() || node.children.size() != 2) {
        reading.diagnostics.error(node.place,
                                  fmt::format("{} must be its first and its last value", what),
                                  fmt::format("write repeat: {{{}: [1, 5]}}", node.key));
        return std::nullopt;
    }
    const auto first = read_whole(reading, node.children[0], "the first value of " + what);
    const auto last = read_whole(reading, node.children[1], "the last value of " + what);
    if (!first || !last) return std::nullopt;
    if (*last >= *first - 1) return Index{node.key, *first, *last};
    reading.diagnostics.error(
        node.place, fmt::format("{} runs backwards, from {} to {}", what, *first, *last),
        "write the smaller value first; an empty range ends one before it begins");
    return std::nullopt;
}

/// A text with the values of the expressions that stand in it in braces: "blade{i + 1}".
void fill_braces(Reading& reading, YamlNode& node) {
    std::string filled;
    std::size_t done = 0;
    for (std::size_t open = node.text.find('{'); open != std::string::npos;
         open = node.text.find('{', done)) {
        const std::size_t close = node.text.find('}', open);
        if (close == std::string::npos) return;
        YamlNode inside = node;
        inside.text = node.text.substr(open + 1, close - open - 1);
        inside.place = place_in(node, open + 1, inside.text.size());
        if (node.text_column > 0) inside.text_column = inside.place.column;
        const auto value = read_whole(reading, inside, "what stands in braces");
        filled += node.text.substr(done, open - done) + std::to_string(value.value_or(0));
        done = close + 1;
    }
    if (done == 0) return;
    node.text = filled + node.text.substr(done);
    node.text_column = 0;
}

void fill_all_braces(Reading& reading, YamlNode& node) {
    if (node.is_scalar()) fill_braces(reading, node);
    for (YamlNode& child : node.children) fill_all_braces(reading, child);
}

/// The key as a text of its own, filled likewise.
void fill_key(Reading& reading, YamlNode& entry) {
    YamlNode key;
    key.kind = YamlNode::Kind::scalar;
    key.text = entry.key;
    key.place = entry.key_place;
    key.text_column = key.place.column;
    key.scope = entry.scope;
    fill_braces(reading, key);
    entry.key = key.text;
}

/// One entry for given values of the indices.
YamlNode repeated(Reading& reading, const YamlNode& entry, const std::vector<Index>& indices,
                  const std::vector<int>& values) {
    auto scope = std::make_shared<InstanceScope>();
    scope->outer = entry.scope;
    scope->repeats = true;
    if (entry.scope) scope->prefix = entry.scope->prefix;
    scope->parameters = parameters_at(reading, entry);
    for (std::size_t n = 0; n < indices.size(); ++n) {
        scope->parameters.values[indices[n].name] = values[n];
    }
    reading.scopes.push_back(scope);
    YamlNode copy = entry;
    set_scope(copy, scope);
    fill_key(reading, copy);
    fill_all_braces(reading, copy);
    return copy;
}

/// Steps the last index first; false after the last values of all.
bool step(const std::vector<Index>& indices, std::vector<int>& values) {
    for (std::size_t n = indices.size(); n-- > 0;) {
        if (values[n]++ < indices[n].last) return true;
        values[n] = indices[n].first;
    }
    return false;
}

bool read_indices(Reading& reading, const YamlNode& repeat, std::vector<Index>& indices) {
    if (!repeat.is_mapping() || repeat.children.empty()) {
        reading.diagnostics.error(
            repeat.place,
            fmt::format("'repeat' must be a mapping of indices, not {}", describe(repeat)),
            "write repeat: {i: [1, 5]}");
        return false;
    }
    double count = 1;
    for (const YamlNode& node : repeat.children) {
        const auto index = read_index(reading, node);
        if (!index) return false;
        indices.push_back(*index);
        count *= index->last - index->first + 1;
    }
    if (count + reading.repeated <= most_repeated) {
        reading.repeated += static_cast<int>(count);
        return count > 0;
    }
    reading.diagnostics.error(repeat.key_place,
                              fmt::format("repetition makes more than {} entries", most_repeated),
                              "give its indices fewer values");
    return false;
}

/// What an entry that cannot be expanded would have named is not told as unknown.
void lose_names_of(Reading& reading, const std::string& section) {
    if (section != "instances") {
        reading.lost_sections.push_back(section);
        return;
    }
    for (const char* made : {"curves", "surfaces", "vertices", "edges", "faces", "blocks"}) {
        reading.lost_sections.emplace_back(made);
    }
}

void add_repeated(Reading& reading, const YamlNode& entry, const YamlNode& repeat,
                  const std::string& section, std::vector<YamlNode>& entries) {
    std::vector<Index> indices;
    const int errors = reading.diagnostics.errors();
    if (!read_indices(reading, repeat, indices)) {
        if (reading.diagnostics.errors() > errors) lose_names_of(reading, section);
        return;
    }
    for (const Index& index : indices) {
        const std::size_t brace = entry.key.find('{');
        if (brace != std::string::npos && entry.key.find(index.name, brace) != std::string::npos) {
            continue;
        }
        reading.diagnostics.error(
            entry.key_place,
            fmt::format("the name '{}' is the same for every '{}'", shown(entry.key), index.name),
            fmt::format("put the index into the name, as in {}{{{}}}", shown(entry.key),
                        index.name));
        lose_names_of(reading, section);
        return;
    }
    std::vector<int> values;
    for (const Index& index : indices) values.push_back(index.first);
    do {
        YamlNode copy = repeated(reading, entry, indices, values);
        if (is_wanted(reading, copy, section)) entries.push_back(std::move(copy));
    } while (step(indices, values));
}

/// Repetition may make a name that is there already.
void drop_repeated_names(Reading& reading, YamlNode& section) {
    std::map<std::string, Place> known;
    std::vector<YamlNode> kept;
    for (YamlNode& entry : section.children) {
        const auto [first, is_new] = known.emplace(entry.key, entry.key_place);
        if (is_new) {
            kept.push_back(std::move(entry));
            continue;
        }
        Diagnostic& d = reading.diagnostics.error(
            entry.key_place, fmt::format("repetition gives the name '{}' twice", shown(entry.key)),
            "give one of the two another name");
        d.notes.push_back({first->second, "first given here"});
    }
    section.children = std::move(kept);
}

}  // namespace

bool holds_entries(std::string_view section) {
    for (const KeyFormat& key : find_format("case")->keys) {
        if (key.key != section) continue;
        return std::any_of(key.values.begin(), key.values.end(), [](const ValueForm& form) {
            return form.kind == ValueForm::Kind::entries;
        });
    }
    return false;
}

void expand_entries(Reading& reading, YamlNode& root) {
    for (YamlNode& section : root.children) {
        if (!section.is_mapping() || !holds_entries(section.key)) continue;
        std::vector<YamlNode> entries;
        bool any_repeated = false;
        for (YamlNode& entry : section.children) {
            const YamlNode* repeat = entry.is_mapping() ? entry.find("repeat") : nullptr;
            any_repeated = any_repeated || repeat != nullptr;
            if (repeat != nullptr) {
                add_repeated(reading, entry, *repeat, section.key, entries);
            } else if (is_wanted(reading, entry, section.key)) {
                entries.push_back(std::move(entry));
            }
        }
        section.children = std::move(entries);
        if (any_repeated) drop_repeated_names(reading, section);
    }
}

void set_scope(YamlNode& node, const std::shared_ptr<InstanceScope>& scope) {
    node.scope = scope;
    for (YamlNode& child : node.children) set_scope(child, scope);
}

}  // namespace hexweave
