// SPDX-License-Identifier: Apache-2.0
// Mappings and lists: which keys are there, which are unknown, and which are lacking.
#include <fmt/format.h>

#include <algorithm>

#include "topology/read_values.h"

namespace hexweave {

namespace {

void tell_unknown_key(Reading& reading, const YamlNode& mapping, const YamlNode& child,
                      const std::string& what, const FormatNames& formats) {
    const Keys keys = keys_of(formats);
    const bool decimals = child.is_null() && !child.key.empty() && child.key.front() >= '0' &&
                          child.key.front() <= '9';
    const std::string meant = meant_word(child.key, keys);
    if (!meant.empty()) {
        reading.misspelled.push_back({&mapping, &child, meant});
        reading.seen.key_of.insert_or_assign(&child, find_key(formats, meant));
    }
    reading.diagnostics.error(child.key_place,
                              fmt::format("unknown key '{}' in {}", shown(child.key), what),
                              decimals ? "a comma separates entries; the decimal separator is "
                                         "the point"
                                       : suggestion(child.key, keys, "keys here are"));
}

/// Notes what the table has of a mapping's keys.
void note_seen(Reading& reading, const YamlNode& mapping, const FormatNames& formats) {
    reading.seen.formats.insert_or_assign(&mapping, formats);
    for (const YamlNode& child : mapping.children) {
        const KeyFormat* key = find_key(formats, child.key);
        if (key != nullptr) reading.seen.key_of.insert_or_assign(&child, key);
    }
}

std::string usage_of_lacking(const Reading& reading, const YamlNode& mapping, const Keys& lacking) {
    const auto formats = reading.seen.formats.find(&mapping);
    if (formats == reading.seen.formats.end()) return {};
    std::vector<const KeyFormat*> keys;
    for (const std::string_view key : lacking) {
        const KeyFormat* known = find_key(formats->second, key);
        if (known != nullptr) keys.push_back(known);
    }
    return usage_of(keys);
}

/// What stands where a mapping is wanted: the keys that it must have, and all.
std::string hint_for_mapping(const FormatNames& formats) {
    std::vector<std::string_view> examples;
    for (const std::string_view key : required_keys(formats.names.front())) {
        examples.push_back(find_key(formats, key)->example);
    }
    const std::string keys = fmt::format("its keys are {}", fmt::join(keys_of(formats), ", "));
    if (examples.empty()) return keys;
    return fmt::format("write {{{}, ...}}; {}", fmt::join(examples, ", "), keys);
}

}  // namespace

bool expect_mapping(Reading& reading, const YamlNode& node, const std::string& what,
                    const FormatNames& formats, const std::vector<RefusedKey>& refused) {
    const Keys keys = keys_of(formats);
    if (!node.is_mapping()) {
        reading.diagnostics.error(node.place,
                                  fmt::format("{} must be a mapping, not {}", what, describe(node)),
                                  hint_for_mapping(formats));
        return false;
    }
    note_seen(reading, node, formats);
    for (const YamlNode& child : node.children) {
        if (std::find(keys.begin(), keys.end(), child.key) != keys.end()) continue;
        const auto special = std::find_if(refused.begin(), refused.end(),
                                          [&](const RefusedKey& r) { return r.key == child.key; });
        if (special != refused.end()) {
            reading.diagnostics.error(child.key_place, std::string(special->message),
                                      std::string(special->hint));
        } else {
            tell_unknown_key(reading, node, child, what, formats);
        }
    }
    return true;
}

const YamlNode* find(const Reading& reading, const YamlNode& mapping, std::string_view key) {
    if (const YamlNode* value = mapping.find(key)) return value;
    const auto meant = std::find_if(
        reading.misspelled.begin(), reading.misspelled.end(),
        [&](const MisspelledKey& m) { return m.mapping == &mapping && m.meant == key; });
    return meant == reading.misspelled.end() ? nullptr : meant->value;
}

std::string usage_of(const Reading& reading, const YamlNode& value) {
    const auto key = reading.seen.key_of.find(&value);
    return key == reading.seen.key_of.end() ? std::string() : usage_of(*key->second);
}

void forget_mappings(Reading& reading, const YamlNode& kept) {
    std::erase_if(reading.misspelled, [&](const MisspelledKey& m) { return m.mapping != &kept; });
    const auto seen = reading.seen.formats.find(&kept);
    const FormatNames formats = seen == reading.seen.formats.end() ? FormatNames{} : seen->second;
    reading.seen = {};
    note_seen(reading, kept, formats);
}

bool has_misspelled(const Reading& reading, const YamlNode& mapping) {
    return std::any_of(reading.misspelled.begin(), reading.misspelled.end(),
                       [&](const MisspelledKey& m) { return m.mapping == &mapping; });
}

const YamlNode* require(Reading& reading, const YamlNode& mapping, std::string_view key,
                        const std::string& what) {
    const YamlNode* value = find(reading, mapping, key);
    if (value == nullptr) tell_lacking(reading, mapping, {key}, what);
    return value;
}

void tell_lacking(Reading& reading, const YamlNode& mapping, const Keys& keys,
                  const std::string& what) {
    Keys lacking;
    for (const std::string_view key : keys) {
        if (find(reading, mapping, key) == nullptr) lacking.push_back(key);
    }
    if (lacking.empty()) return;
    reading.diagnostics.error(
        mapping.key_place.line > 0 ? mapping.key_place : mapping.place,
        fmt::format("{} lacks the key{} '{}'", what, lacking.size() > 1 ? "s" : "",
                    fmt::join(lacking, "', '")),
        usage_of_lacking(reading, mapping, lacking));
}

bool expect_list(Reading& reading, const YamlNode& node, const std::string& what,
                 std::size_t count) {
    if (node.is_sequence() && (count == 0 || node.children.size() == count)) return true;
    const std::string size = count == 0 ? "a list" : fmt::format("a list of {}", count);
    const std::string found =
        node.is_sequence() ? fmt::format("of {}", node.children.size()) : describe(node);
    reading.diagnostics.error(node.place, fmt::format("{} must be {}, not {}", what, size, found),
                              usage_of(reading, node));
    return false;
}

}  // namespace hexweave
