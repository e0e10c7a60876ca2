// SPDX-License-Identifier: Apache-2.0
// What was measured of a grid in a run, as people read it.
#pragma once

#include <string>

#include "quality/report.h"

namespace hexweave {

/// The worst cell of a zone by its indices from 1, "(3, 1, 20)"; two in the plane.
std::string worst_cell_text(const ZoneMeasure& zone);

/// A row per zone, and how many corners at poles are counted apart.
std::string zone_table(const Report& report);
/// The least and greatest angle, and how many are nearly right; empty where none was measured.
std::string angle_line(const Report& report);
/// The greatest growth along the lines of each axis, and across interfaces.
std::string growth_line(const Report& report);
/// A line per family of walls: how lines leave it, and the first heights.
std::string wall_lines(const Report& report);

}  // namespace hexweave
