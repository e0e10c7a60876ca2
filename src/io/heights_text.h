// SPDX-License-Identifier: Apache-2.0
// First heights in the report of a run: asked and got, side by side.
#pragma once

#include <string>

#include "quality/report.h"

namespace hexweave {

/// Tables of the sides at which heights are held, and of the walls at which they are not. Ends with
/// an empty line; empty where there is neither.
std::string heights_text(const Report& report);

}  // namespace hexweave
