// SPDX-License-Identifier: Apache-2.0
// What a surface's entry says of its parameters: a part of their range, swapped, run backwards.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "geometry/surface.h"
#include "topology/read_values.h"

namespace hexweave {

/// The surface with the parameters that its entry asks for: `range` first, then `swap`, then
/// `reverse` of the parameters that come out. Nothing after an error.
std::optional<Surface> with_parameters(Reading& reading, const YamlNode& entry, Surface surface);

/// Two different values of a parameter, the first of which may be the greater one: within its
/// range or, where the surface is closed, at most a period apart. `name`: "u".
std::optional<std::array<double, 2>> read_parameter_range(Reading& reading, const YamlNode& node,
                                                          const std::string& name,
                                                          const std::array<double, 2>& range,
                                                          bool closed);

/// A value of a parameter, within its range unless the surface is closed there.
std::optional<double> read_parameter(Reading& reading, const YamlNode& node,
                                     const std::string& name, const std::array<double, 2>& range,
                                     bool closed);

}  // namespace hexweave
