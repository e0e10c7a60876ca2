// SPDX-License-Identifier: Apache-2.0
// The families of curves: lines, splines, circles, airfoils, formulas.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/curve.h"
#include "topology/read_values.h"

namespace hexweave {

using MaybeCurve = std::optional<Curve>;

/// A family: its key, and how an entry that has its key is read; `curve_KEY` in the format's table.
struct CurveFamily {
    std::string_view key;
    MaybeCurve (*read)(Reading& reading, const YamlNode& entry);
};

/// Points in a list, or in the file that a mapping names; nothing after an error.
std::optional<std::vector<Vec3>> read_points(Reading& reading, const YamlNode& node,
                                             const std::string& what);

/// All families but those of curves made of other shapes.
const std::vector<CurveFamily>& curve_families();

}  // namespace hexweave
