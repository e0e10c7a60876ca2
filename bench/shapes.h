// SPDX-License-Identifier: Apache-2.0
// Formulas that several problems are drawn with.
#pragma once

#include <vector>

#include "core/vec3.h"

namespace hexweave::bench {

/// Half the thickness of NACA 0012 with a closed trailing edge at x of a unit chord.
double half_thickness(double x);

/// x on a unit chord, from the trailing (u = 0) to the leading edge, dense at both.
double chord_fraction(double u);

/// The quarter of the unit sphere y, z >= 0 by circles from +x to -x: the first (v = 0) is the half
/// circle in y = 0, the last lies in z = 0, and the ends of all lie in z = 0, each a quarter of its
/// half circle.
Vec3 quarter_sphere(double u, double v);

/// Points of the straight line from a to b whose first interval is `first` long and which grow
/// geometrically from there.
std::vector<Vec3> geometric_line(const Vec3& a, const Vec3& b, int points, double first);

}  // namespace hexweave::bench
