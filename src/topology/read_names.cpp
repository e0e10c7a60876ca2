// SPDX-License-Identifier: Apache-2.0
// Names, where they are given and where they are used.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "topology/instance_scope.h"
#include "topology/read_values.h"

namespace hexweave {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_name(std::string_view text, std::string_view further) {
    const auto letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    return !text.empty() && letter(text.front()) &&
           std::all_of(text.begin(), text.end(), [&](char c) {
               return letter(c) || is_digit(c) || further.find(c) != std::string::npos;
           });
}

/// YAML 1.1 reads these as truth values: other programs would take such a name for one.
bool is_yaml_switch(const std::string& text) {
    static constexpr std::array<std::string_view, 9> words{"y",   "n",    "yes",   "no",  "on",
                                                           "off", "true", "false", "null"};
    std::string lower = text;
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return std::find(words.begin(), words.end(), lower) != words.end();
}

/// The nearest valid name: every other character an underscore, and a letter first.
std::string made_valid(const std::string& name, const std::string& kind) {
    std::string valid;
    for (const char c : name) {
        const bool continues = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
        if (!continues) valid += is_name(std::string("_") + c, "") ? c : '_';
    }
    if (valid.empty() || is_digit(valid.front())) valid.insert(0, 1, kind.front());
    return shown(valid);
}

void tell_no_name(Reading& reading, const YamlNode& node, const std::string& what) {
    const bool words = node.is_scalar() && node.text.find_first_of(" ,") != std::string::npos;
    std::string hint = usage_of(reading, node);
    if (words) hint = "a name has no spaces; write several as a list: [a, b]";
    if (hint.empty()) hint = "a name begins with a letter: a-z, A-Z or _";
    reading.diagnostics.error(node.place,
                              fmt::format("{} must be a name, not {}", what, describe(node)), hint);
}

}  // namespace

bool check_new_name(Reading& reading, const YamlNode& node, const std::string& kind,
                    std::size_t longest) {
    const std::string name = local_name(node.key, node.scope);
    if (!is_name(name, "")) {
        reading.diagnostics.error(
            node.key_place, fmt::format("'{}' is not a valid {} name", shown(name), kind),
            fmt::format("a name has letters (a-z, A-Z), digits and underscores, and no digit "
                        "first: '{}' would do",
                        made_valid(name, kind)));
    } else if (is_yaml_switch(name)) {
        reading.diagnostics.error(node.key_place,
                                  fmt::format("'{}' is not a valid {} name", shown(name), kind),
                                  fmt::format("other YAML programs read it as true, false or "
                                              "null; '{}_' would do",
                                              name));
    } else if (node.key.size() > longest && name == node.key) {
        reading.diagnostics.error(
            node.key_place,
            fmt::format("the name of this {} has {} characters; at most {} are allowed", kind,
                        node.key.size(), longest),
            "shorten it: files hold no longer one");
    } else if (node.key.size() > longest) {
        reading.diagnostics.error(
            node.key_place,
            fmt::format("the name of this {} is '{}' in full; at most {} characters are allowed",
                        kind, shown(node.key), longest),
            "shorten it, or the name of the instance: files hold no longer one");
    } else {
        return true;
    }
    return false;
}

Name read_name(Reading& reading, const YamlNode& node, const std::string& what) {
    if (node.is_scalar() && is_name(node.text, "-.")) {
        return {qualified(node.text, node.scope), node.place};
    }
    tell_no_name(reading, node, what);
    return {{}, node.place};
}

std::vector<Name> read_names(Reading& reading, const YamlNode& node, const std::string& what) {
    if (!node.is_sequence()) return {read_name(reading, node, what)};
    std::vector<Name> names;
    for (const YamlNode& item : node.children) {
        Name name = read_name(reading, item, fmt::format("a name of {}", what));
        const bool again = std::any_of(names.begin(), names.end(), [&](const Name& other) {
            return !name.value.empty() && other.value == name.value;
        });
        if (again) {
            reading.diagnostics.error(item.place,
                                      fmt::format("{} names '{}' twice", what, shown(name.value)),
                                      "name it once");
            name.value.clear();
        }
        names.push_back(std::move(name));
    }
    if (!names.empty()) return names;
    reading.diagnostics.error(node.place, fmt::format("{} names nothing", what),
                              usage_of(reading, node));
    return {Name{{}, node.place}};
}

SignedName read_signed_name(Reading& reading, const YamlNode& node, const std::string& what) {
    const char sign = node.is_scalar() && !node.text.empty() ? node.text.front() : ' ';
    if (sign != '-' && sign != '+') {
        return {read_name(reading, node, what).value, false, false, node.place};
    }
    const std::string name = node.text.substr(1);
    if (is_name(name, "-.")) {
        return {qualified(name, node.scope), sign == '-', true, node.place};
    }
    tell_no_name(reading, node, what);
    return {{}, false, false, node.place};
}

}  // namespace hexweave
