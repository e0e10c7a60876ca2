// SPDX-License-Identifier: Apache-2.0
// The `spacing:` of an edge.
#pragma once

#include <optional>

#include "topology/case.h"
#include "topology/read_values.h"

namespace hexweave {

std::optional<SpacingEntry> read_spacing(Reading& reading, const YamlNode& node);

}  // namespace hexweave
