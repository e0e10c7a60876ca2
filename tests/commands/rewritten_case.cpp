// SPDX-License-Identifier: Apache-2.0
#include "tests/commands/rewritten_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <random>
#include <regex>
#include <set>
#include <utility>
#include <vector>

namespace hexweave::testing {
namespace {

using Names = std::map<std::string, std::string>;

const std::vector<std::string> named_sections{"curves", "surfaces", "vertices", "edges",
                                              "faces",  "blocks",   "periodic", "boundaries"};

/// 0 to count - 1 in another order.
std::vector<std::size_t> shuffled(std::size_t count, std::mt19937& random) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t n = count; n > 1; --n) std::swap(order[n - 1], order[random() % n]);
    return order;
}

YAML::Node shuffled_mapping(const YAML::Node& mapping, std::mt19937& random) {
    std::vector<std::string> keys;
    for (const auto& entry : mapping) keys.push_back(entry.first.as<std::string>());
    YAML::Node result(YAML::NodeType::Map);
    for (const std::size_t n : shuffled(keys.size(), random)) result[keys[n]] = mapping[keys[n]];
    return result;
}

YAML::Node shuffled_list(const YAML::Node& list, std::mt19937& random) {
    if (!list.IsSequence()) return list;
    YAML::Node result(YAML::NodeType::Sequence);
    for (const std::size_t n : shuffled(list.size(), random)) result.push_back(list[n]);
    return result;
}

/// Files are known by where they are, as the rewritten case is elsewhere.
void make_absolute(YAML::Node node, const std::filesystem::path& folder) {
    if (node.IsSequence()) {
        for (const auto& item : node) make_absolute(item, folder);
    }
    if (!node.IsMap()) return;
    for (const auto& entry : node) {
        const auto key = entry.first.as<std::string>();
        const bool file = entry.second.IsScalar() && (key == "airfoil" || key == "file");
        if (file) node[key] = (folder / entry.second.as<std::string>()).string();
        if (!file) make_absolute(entry.second, folder);
    }
}

const std::set<std::string> keys_of_names{
    "of",   "surface", "ruled", "curve", "along", "from", "to",      "at",    "like", "imin",
    "imax", "jmin",    "jmax",  "kmin",  "kmax",  "face", "corners", "sides", "in"};
const std::set<std::string> keys_of_numbers{"heights", "require", "arc", "axes", "parameters"};

/// Every name in a text, on its own or as in `-a` and `a-b`.
std::string renamed_text(const std::string& text, const Names& names) {
    static const std::regex word("[A-Za-z_][A-Za-z0-9_]*");
    std::string result;
    auto rest = text.begin();
    for (std::sregex_iterator match(text.begin(), text.end(), word), end; match != end; ++match) {
        const auto found = names.find(match->str());
        result.append(rest, text.begin() + match->position());
        result += found == names.end() ? match->str() : found->second;
        rest = text.begin() + match->position() + match->length();
    }
    return result.append(rest, text.end());
}

YAML::Node renamed_value(const std::string& key, const YAML::Node& value, const Names& names) {
    if (keys_of_numbers.count(key) == 1) return value;
    if (value.IsMap()) {
        return with_each(value, [&](const std::string& inner, const YAML::Node& held) {
            return renamed_value(inner, held, names);
        });
    }
    if (keys_of_names.count(key) == 0) return value;
    if (value.IsScalar()) return YAML::Node(renamed_text(value.Scalar(), names));
    YAML::Node list(YAML::NodeType::Sequence);
    for (const auto& item : value) list.push_back(renamed_value(key, item, names));
    return list;
}

}  // namespace

YAML::Node case_of(const std::string& path) {
    YAML::Node written = YAML::LoadFile(path);
    written.remove("output");
    make_absolute(written, std::filesystem::path(path).parent_path());
    return written;
}

std::string text_of(const YAML::Node& node) {
    return YAML::Dump(node) + "\n";
}

YAML::Node reordered(const YAML::Node& written, unsigned seed) {
    std::mt19937 random(seed);
    const auto with_sides = [&](const std::string&, const YAML::Node& boundary) {
        return with_each(boundary, [&](const std::string& key, const YAML::Node& value) {
            return key == "sides" ? shuffled_list(value, random) : value;
        });
    };
    const auto shuffled_section = [&](const std::string& key, const YAML::Node& section) {
        if (!section.IsMap() || key == "parameters") return section;
        const YAML::Node entries = shuffled_mapping(section, random);
        return key == "boundaries" ? with_each(entries, with_sides) : entries;
    };
    return shuffled_mapping(with_each(written, shuffled_section), random);
}

Names new_names(const YAML::Node& written) {
    std::set<std::string> old;
    for (const std::string& section : named_sections) {
        if (!written[section]) continue;
        for (const auto& entry : written[section]) old.insert(entry.first.as<std::string>());
    }
    Names names;
    std::size_t left = old.size();
    for (const std::string& name : old) names[name] = fmt::format("n{:03}", left--);
    return names;
}

YAML::Node renamed(const YAML::Node& written, const Names& names) {
    return with_each(written, [&](const std::string& key, const YAML::Node& section) {
        const bool named = std::count(named_sections.begin(), named_sections.end(), key) == 1;
        if (!named) return section;
        YAML::Node result(YAML::NodeType::Map);
        for (const auto& entry : section) {
            const auto& name = names.at(entry.first.as<std::string>());
            // A list here is a point, or a single value that holds no name.
            result[name] =
                entry.second.IsMap() ? renamed_value("", entry.second, names) : entry.second;
        }
        return result;
    });
}

YAML::Node as_instance(const YAML::Node& written, const std::string& transform) {
    YAML::Node whole(YAML::NodeType::Map);
    YAML::Node result(YAML::NodeType::Map);
    for (const auto& entry : written) {
        const auto key = entry.first.as<std::string>();
        const bool named = std::count(named_sections.begin(), named_sections.end(), key) == 1;
        (named || key == "parameters" ? whole : result)[key] = entry.second;
    }
    YAML::Node instance(YAML::NodeType::Map);
    instance["of"] = "whole";
    instance["transform"].push_back(YAML::Load(transform));
    for (const auto& entry : written["parameters"]) {
        const auto name = entry.first.as<std::string>();
        instance["set"][name] = name;
        result["parameters"][name] = entry.second;
    }
    result["components"]["whole"] = whole;
    result["instances"]["it"] = instance;
    return result;
}

}  // namespace hexweave::testing
