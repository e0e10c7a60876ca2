// SPDX-License-Identifier: Apache-2.0
// The comparison of two grid files, for `hexweave compare` and `hexweave run --golden`.
#pragma once

#include <string>

#include "quality/grid_comparison.h"

namespace hexweave {

/// Reads two structured CGNS files piece by piece and compares them. Throws UsageError where one
/// cannot be read.
GridComparison compare_files(const std::string& candidate, const std::string& golden,
                             const ComparisonOptions& options);

}  // namespace hexweave
