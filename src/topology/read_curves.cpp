// SPDX-License-Identifier: Apache-2.0
#include "topology/read_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geometry/transform.h"
#include "topology/read_family.h"
#include "topology/read_shapes.h"
#include "topology/read_surface_curves.h"
#include "topology/read_transforms.h"

namespace hexweave {

namespace {

MaybeCurve read_other_curve(Shapes& shapes, const YamlNode& entry) {
    const auto other = use_curve(shapes, *entry.find("of"), "'of'");
    return other ? MaybeCurve(*other) : std::nullopt;
}

/// A family whose curves are made of other shapes.
struct MadeFamily {
    std::string_view key;
    FormatNames formats;
    MaybeCurve (*read)(Shapes& shapes, const YamlNode& entry);
};

const std::vector<MadeFamily>& made_families() {
    static const std::vector<MadeFamily> list{
        {"of", "curve_of", read_other_curve},
        {"surface",
         {"curve_of_equal_u", "curve_of_equal_v", "curve_of_side", "curve_of_line",
          "curve_of_points"},
         read_surface_curve},
    };
    return list;
}

const Keys& family_names() {
    static const Keys names = [] {
        Keys list;
        for (const CurveFamily& family : curve_families()) list.push_back(family.key);
        for (const MadeFamily& family : made_families()) list.push_back(family.key);
        return list;
    }();
    return names;
}

template <class Family>
const Family* find_family(const std::vector<Family>& families, const std::string& key) {
    const auto found = std::find_if(families.begin(), families.end(),
                                    [&](const Family& f) { return f.key == key; });
    return found == families.end() ? nullptr : &*found;
}

}  // namespace

std::shared_ptr<const Curve> read_curve(Shapes& shapes, const YamlNode& entry) {
    Reading& reading = shapes.reading;
    const std::string what = fmt::format("curve '{}'", shown(entry.key));
    // A curve on a surface may have a 'line' of its own.
    const std::string key = entry.find("surface") != nullptr
                                ? "surface"
                                : read_family(reading, entry, what, family_names());
    const CurveFamily* family = find_family(curve_families(), key);
    const MadeFamily* made = find_family(made_families(), key);
    if (family == nullptr && made == nullptr) return nullptr;  // told by read_family
    expect_mapping(reading, entry, what,
                   made != nullptr ? made->formats : FormatNames("curve_" + key));

    MaybeCurve shape = family != nullptr ? family->read(reading, entry) : made->read(shapes, entry);
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

}  // namespace hexweave
