// SPDX-License-Identifier: Apache-2.0
// Corners of a face that are so wide that the arc length is a poor edge function there.
#pragma once

#include <array>

#include "core/field.h"
#include "faces/edge_functions.h"

namespace hexweave {

/// Two sides meet flat when the angle between them, through the grid, is greater than this. [rad]
inline constexpr double flat_angle = 150 * 3.14159265358979323846 / 180;
/// ... and less than this: beyond, an angle of 360 degrees cannot be told from one of none.
inline constexpr double slit_angle = 330 * 3.14159265358979323846 / 180;

/// Whether the angle of each corner (in the order of Face::corners), between the first cells of its
/// two sides, is flat. Corners of a planar face (right-handed) are measured through the face; of
/// another, whose normal is not known yet, as the lesser of the two angles.
std::array<bool, 4> flat_corners(const PointField& boundary, bool planar);

/// The exponents of the sides imin, imax, jmin, jmax of a face: `exponent` at every end that lies
/// in a flat corner, 1 elsewhere.
std::array<EndExponents, 4> corner_exponents(const std::array<bool, 4>& flat, double exponent);

}  // namespace hexweave
