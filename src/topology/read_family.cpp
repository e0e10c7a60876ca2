// SPDX-License-Identifier: Apache-2.0
#include "topology/read_family.h"

#include <fmt/format.h>

#include <algorithm>

namespace hexweave {

namespace {

void tell_shape(Reading& reading, const Place& place, const std::string& message,
                const Keys& names) {
    reading.diagnostics.error(place, message,
                              fmt::format("it has one key of {}", fmt::join(names, ", ")));
}

}  // namespace

std::string read_family(Reading& reading, const YamlNode& entry, const std::string& what,
                        const Keys& names) {
    if (!entry.is_mapping()) {
        tell_shape(reading, entry.is_null() ? entry.key_place : entry.place,
                   fmt::format("{} must be a mapping, not {}", what, describe(entry)), names);
        return {};
    }
    std::string found;
    for (const YamlNode& child : entry.children) {
        if (std::find(names.begin(), names.end(), child.key) == names.end()) continue;
        if (!found.empty()) {
            tell_shape(reading, child.key_place,
                       fmt::format("{} is already given by '{}'", what, found), names);
            return {};
        }
        found = child.key;
    }
    if (!found.empty()) return found;
    for (const YamlNode& child : entry.children) {
        const std::string nearest = nearest_name(child.key, {names.begin(), names.end()});
        if (nearest.empty()) continue;
        reading.diagnostics.error(child.key_place,
                                  fmt::format("unknown key '{}' in {}", shown(child.key), what),
                                  fmt::format("did you mean '{}'?", nearest));
        return {};
    }
    tell_shape(reading, entry.key_place, fmt::format("{} has no shape", what), names);
    return {};
}

}  // namespace hexweave
