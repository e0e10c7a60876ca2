// SPDX-License-Identifier: Apache-2.0
// The bench's tables, for people and for programs.
#pragma once

#include <string>

#include "bench/comparison.h"

namespace hexweave::bench {

/// The tables as text. Of SLOR's relaxation factors only the best is shown.
std::string report_text(const Comparison& all);
/// Everything that was measured.
std::string report_json(const Comparison& all);

}  // namespace hexweave::bench
