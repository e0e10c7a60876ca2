// SPDX-License-Identifier: Apache-2.0
// The report of a run as people read it.
#pragma once

#include <string>

#include "quality/report.h"

namespace hexweave {

/// Several lines: cells, spacings asked and got, solves, quality, notes, seconds per stage. With
/// `verbose` also a line per zone and the convergence history of every solve.
std::string to_text(const Report& report, bool verbose);

/// One line: "sound: 32,768 cells, ..." or "NOT SOUND: 12 folded cells in zone 'above', ...".
std::string verdict(const Report& report);

}  // namespace hexweave
