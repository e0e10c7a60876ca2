// SPDX-License-Identifier: Apache-2.0
#include "topology/read_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "geometry/transform.h"
#include "topology/read_family.h"
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
        Keys known;
        for (const CurveEntry& c : curves.entries) known.emplace_back(c.name.value);
        tell_not_before(reading, node, "curve", curves.section, known);
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

std::shared_ptr<const Curve> read_curve(Reading& reading, CurvesSoFar& curves,
                                        const YamlNode& entry) {
    const std::string what = fmt::format("curve '{}'", shown(entry.key));
    const std::string key = read_family(reading, entry, what, family_names());
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
