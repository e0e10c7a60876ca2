// SPDX-License-Identifier: Apache-2.0
// Airfoil coordinate files: Selig order, Lednicer order, or a symmetric half.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/vec3.h"

namespace hexweave {

/// What a coordinate file holds. `section`: both sides, in Selig order (one pass over the trailing
/// edge, one side, the leading edge, the other side, the trailing edge) or in Lednicer order (two
/// blocks, each from the leading edge to the trailing edge, with or without a line of their counts
/// such as "65. 65."); told apart by their numbers. `symmetric_half`: one side, mirrored at y = 0.
enum class AirfoilContent { section, symmetric_half };

/// The points of an airfoil, from the trailing edge along the upper side over the leading edge and
/// along the lower side to the trailing edge, z = 0. Either there are points, or `error` says what
/// is wrong; `line` counts from 1, 0 for the file as a whole.
struct AirfoilPoints {
    std::vector<Vec3> points;
    std::string error;
    int line = 0;
};

/// Reads a coordinate file: two numbers a line, x and y, between them blanks, tabs or a comma.
/// Lines above the first pair of numbers are titles and skipped (so is a line of four numbers, the
/// box of an MSES file); empty lines are skipped. A file that runs along the lower side first is
/// turned round. Faults: text among the coordinates, other than two numbers on a line, a number
/// that is not finite, too few points, two consecutive points that coincide, one side only where a
/// section is asked, several sections (separated by "999 999"), counts that do not match, no area.
AirfoilPoints read_airfoil(std::string_view text, AirfoilContent content = AirfoilContent::section);

}  // namespace hexweave
