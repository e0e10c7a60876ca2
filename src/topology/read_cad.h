// SPDX-License-Identifier: Apache-2.0
// Surfaces and curves of CAD files: which one an entry means, and in which unit.
#pragma once

#include <optional>

#include "geometry/curve.h"
#include "geometry/surface.h"
#include "topology/read_values.h"

namespace hexweave {

/// The surface (curve) that an entry with a key `cad` names, its lengths in the units of the case;
/// nothing after an error. A file that several entries name is read once.
std::optional<Surface> read_cad_surface(Reading& reading, const YamlNode& entry);
std::optional<Curve> read_cad_curve(Reading& reading, const YamlNode& entry);

}  // namespace hexweave
