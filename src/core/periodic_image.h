// SPDX-License-Identifier: Apache-2.0
// The one function that carries points across a periodic interface: grids are made with it, and
// measured with it.
#pragma once

#include <array>
#include <limits>

#include "core/multiblock.h"
#include "core/vec3.h"

namespace hexweave {

/// The map of a Periodicity, made once: turns about x, then y, then z through the centre, then goes
/// the way of the translation. Quarter turns are exact. A coordinate that no turn changes is kept
/// to the bit (but for the translation), so that a turn about x, y or z leaves its axis in place.
struct PeriodicMap {
    std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    Vec3 center;
    Vec3 translation;
};

PeriodicMap periodic_map(const Periodicity& periodicity);

/// The image of a point of an interface's own zone.
Vec3 image(const PeriodicMap& map, const Vec3& point);

/// The image of a way from one such point to another: turned, not moved.
Vec3 image_of_way(const PeriodicMap& map, const Vec3& way);

/// How far an image may be off by round-off alone, where two periodic interfaces lead to one point,
/// or where a file keeps the map in single precision: some last places of the coordinates' size.
double image_rounding(const PeriodicMap& map, const Vec3& point,
                      double epsilon = std::numeric_limits<double>::epsilon());

}  // namespace hexweave
