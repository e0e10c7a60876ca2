// SPDX-License-Identifier: Apache-2.0
// How the values that several JSON documents share are written (docs/json.md): numbers that are not
// finite are null, indices count from 1.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "core/field.h"
#include "core/orientation.h"
#include "core/vec3.h"
#include "quality/report.h"

namespace hexweave {

using Json = nlohmann::ordered_json;

Json json_of(double value);
Json json_of(const std::optional<double>& value);
Json json_of(const Vec3& point);
Json json_of(const std::optional<Vec3>& point);
Json json_of(const Extent& extent);
/// A node or a cell.
Json json_of(const Node& index);
Json json_of(const AngleMeasure& angles);
Json json_of(const GrowthMeasure& growth);
Json json_of(const WallMeasure& wall);
Json json_of(const ZoneMeasure& zone);

/// A list of what `convert` makes of the items.
template <class Items, class Convert>
Json json_list(const Items& items, Convert convert) {
    Json list = Json::array();
    for (const auto& item : items) list.push_back(convert(item));
    return list;
}

}  // namespace hexweave
