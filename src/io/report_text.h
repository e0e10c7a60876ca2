// SPDX-License-Identifier: Apache-2.0
// The report of a run as people read it.
#pragma once

#include <string>

#include "quality/report.h"

namespace hexweave {

/// Several lines: cells, spacings asked and got, solves, quality, seconds per stage. With `verbose`
/// also a line per zone and the convergence history of every solve.
std::string to_text(const Report& report, bool verbose);

/// One line: "sound: 32,768 cells, ..." or "NOT SOUND: 12 folded cells in zone 'above', ...".
std::string verdict(const Report& report);

/// What is no fault of the grid but ought to be known, a line each: faces within a grid of blocks
/// that fold as surfaces. Empty where there is nothing.
std::string cautions(const Report& report);

}  // namespace hexweave
