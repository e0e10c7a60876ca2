// SPDX-License-Identifier: Apache-2.0
#include "topology/expand_entries.h"

#include <fmt/format.h>

#include <algorithm>

namespace hexweave {

namespace {

bool is_wanted(Reading& reading, const YamlNode& entry) {
    const YamlNode* when = entry.find("when");
    return when == nullptr || read_number(reading, *when, "'when'").value_or(0) != 0;
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

void choose_entries(Reading& reading, YamlNode& root) {
    for (YamlNode& section : root.children) {
        if (!section.is_mapping() || !holds_entries(section.key)) continue;
        std::vector<YamlNode>& entries = section.children;
        const auto unwanted = [&](const YamlNode& entry) { return !is_wanted(reading, entry); };
        entries.erase(std::remove_if(entries.begin(), entries.end(), unwanted), entries.end());
    }
}

}  // namespace hexweave
