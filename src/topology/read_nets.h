// SPDX-License-Identifier: Apache-2.0
// Curves and surfaces given by control points: rational B-splines, and surfaces through points.
#pragma once

#include <optional>

#include "geometry/curve.h"
#include "geometry/surface.h"
#include "topology/read_values.h"

namespace hexweave {

/// The `nurbs` of a curve's (a surface's) entry; nothing after an error.
std::optional<Curve> read_nurbs_curve(Reading& reading, const YamlNode& entry);
std::optional<Surface> read_nurbs_surface(Reading& reading, const YamlNode& entry);

/// The `control_points` of a surface's entry: rows of points, or a file.
std::optional<Surface> read_control_points(Reading& reading, const YamlNode& entry);

}  // namespace hexweave
