// SPDX-License-Identifier: Apache-2.0
// Periodic interfaces, and turns about axes, as a file writes them.
#pragma once

#include <optional>
#include <vector>

#include "topology/case.h"
#include "topology/read_values.h"

namespace hexweave {

/// An entry for every key of `periodic:`, in order; those whose map could not be read are left out.
std::vector<PeriodicEntry> read_periodic(Reading& reading, const YamlNode& section);

}  // namespace hexweave
