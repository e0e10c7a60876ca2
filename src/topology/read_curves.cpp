// SPDX-License-Identifier: Apache-2.0
#include "topology/read_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "geometry/transform.h"
#include "topology/read_shapes.h"
#include "topology/read_transforms.h"

namespace hexweave {

namespace {

/// How many curves may be made of one another in a row.
constexpr int longest_descent = 100;

/// The curves read so far, and the names of all.
struct CurvesSoFar {
    const YamlNode& section;
    std::vector<CurveEntry> entries;
    std::map<std::string, int> descent;  ///< how many curves each is made of, in a row
};

MaybeCurve read_other_curve(Reading& reading, CurvesSoFar& curves, const YamlNode& entry) {
    const YamlNode& node = *entry.find("of");
    const Name name = read_name(reading, node, "'of'");
    if (name.value.empty()) return std::nullopt;
    const auto other =
        std::find_if(curves.entries.begin(), curves.entries.end(),
                     [&](const CurveEntry& c) { return c.name.value == name.value; });
    if (other == curves.entries.end()) {
        std::vector<std::string_view> known;
        for (const CurveEntry& c : curves.entries) known.emplace_back(c.name.value);
        const bool later = curves.section.find(name.value) != nullptr;
        reading.diagnostics.error(
            node.place,
            later ? fmt::format("the curve '{}' is used before it is defined", name.value)
                  : fmt::format("unknown curve '{}'", name.value),
            later           ? "a curve can be made only of those that stand before it"
            : known.empty() ? std::string()
                            : suggestion(name.value, known, "curves before this one are"));
        return std::nullopt;
    }
    other->used_by_curve = true;
    const int descent = curves.descent[name.value] + 1;
    curves.descent[entry.key] = descent;
    if (descent > longest_descent) {
        reading.diagnostics.error(
            node.place,
            fmt::format("more than {} curves are made of one another", longest_descent));
        return std::nullopt;
    }
    if (!other->shape) return std::nullopt;
    return *other->shape;
}

const Keys& family_names() {
    static const Keys names = [] {
        Keys list;
        for (const CurveFamily& family : curve_families()) list.push_back(family.key);
        list.emplace_back("of");
        return list;
    }();
    return names;
}

/// Tells what is wrong with the shape of a curve.
void tell_shape(Reading& reading, const Place& place, const std::string& message) {
    reading.diagnostics.error(place, message,
                              fmt::format("it has one key of {}", fmt::join(family_names(), ", ")));
}

/// The key of the one family that an entry names; empty after an error.
std::string read_family(Reading& reading, const YamlNode& entry, const std::string& what) {
    if (!entry.is_mapping()) {
        tell_shape(reading, entry.is_null() ? entry.key_place : entry.place,
                   fmt::format("{} must be a mapping, not {}", what, describe(entry)));
        return {};
    }
    const Keys& names = family_names();
    std::string found;
    for (const YamlNode& child : entry.children) {
        if (std::find(names.begin(), names.end(), child.key) == names.end()) continue;
        if (!found.empty()) {
            tell_shape(reading, child.key_place,
                       fmt::format("{} is already given by '{}'", what, found));
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
    tell_shape(reading, entry.key_place, fmt::format("{} has no shape", what));
    return {};
}

std::shared_ptr<const Curve> read_curve(Reading& reading, CurvesSoFar& curves,
                                        const YamlNode& entry) {
    const std::string what = fmt::format("curve '{}'", shown(entry.key));
    const std::string key = read_family(reading, entry, what);
    if (key.empty()) return nullptr;
    const auto family = std::find_if(curve_families().begin(), curve_families().end(),
                                     [&](const CurveFamily& f) { return f.key == key; });
    const bool of_another = family == curve_families().end();
    Keys keys{key};
    if (!of_another) keys.insert(keys.end(), family->further.begin(), family->further.end());
    keys.insert(keys.end(), transform_keys().begin(), transform_keys().end());
    keys.emplace_back("reverse");
    expect_mapping(reading, entry, what, keys);

    MaybeCurve shape =
        of_another ? read_other_curve(reading, curves, entry) : family->read(reading, entry);
    const std::optional<std::vector<Affine>> maps = read_transforms(reading, entry, what);
    const std::optional<bool> backwards = read_switch(reading, entry, "reverse");
    if (!shape || !maps || !backwards || has_misspelled(reading, entry)) return nullptr;
    if (!maps->empty()) {
        Affine whole;
        for (const Affine& map : *maps) whole = compose(whole, map);
        shape = transformed(*shape, whole);
    }
    if (*backwards) shape = reversed(*shape);
    return std::make_shared<const Curve>(std::move(*shape));
}

}  // namespace

std::vector<CurveEntry> read_curves(Reading& reading, const YamlNode& section) {
    CurvesSoFar curves{section, {}, {}};
    for (const YamlNode& entry : section.children) {
        check_new_name(reading, entry, "curve");
        std::shared_ptr<const Curve> shape = read_curve(reading, curves, entry);
        curves.entries.push_back({{entry.key, entry.key_place}, std::move(shape), false});
    }
    return std::move(curves.entries);
}

}  // namespace hexweave
