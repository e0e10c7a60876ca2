// SPDX-License-Identifier: Apache-2.0
#include "core/periodic_image.h"

#include <cstddef>

#include "core/turn.h"

namespace hexweave {

namespace {

/// Turns every column of a matrix in the plane of its rows a and b.
void turn_rows(std::array<Vec3, 3>& rows, std::size_t a, std::size_t b, const Turn& turn) {
    const Vec3 first = rows[a];
    const Vec3 second = rows[b];
    rows[a] = turn.cosine * first - turn.sine * second;
    rows[b] = turn.sine * first + turn.cosine * second;
}

/// One coordinate of the turned point.
double turned(const Vec3& row, const Vec3& unit, double kept, double center, const Vec3& arm) {
    return row == unit ? kept : center + dot(row, arm);
}

}  // namespace

PeriodicMap periodic_map(const Periodicity& periodicity) {
    PeriodicMap map;
    map.center = periodicity.center;
    map.translation = periodicity.translation;
    const Vec3& angle = periodicity.angle;
    if (angle.x != 0) turn_rows(map.rows, 1, 2, turn_by(angle.x));
    if (angle.y != 0) turn_rows(map.rows, 2, 0, turn_by(angle.y));
    if (angle.z != 0) turn_rows(map.rows, 0, 1, turn_by(angle.z));
    return map;
}

Vec3 image(const PeriodicMap& map, const Vec3& point) {
    const Vec3 arm = point - map.center;
    const Vec3 at{turned(map.rows[0], {1, 0, 0}, point.x, map.center.x, arm),
                  turned(map.rows[1], {0, 1, 0}, point.y, map.center.y, arm),
                  turned(map.rows[2], {0, 0, 1}, point.z, map.center.z, arm)};
    return at + map.translation;
}

Vec3 image_of_way(const PeriodicMap& map, const Vec3& way) {
    return {dot(map.rows[0], way), dot(map.rows[1], way), dot(map.rows[2], way)};
}

double image_rounding(const PeriodicMap& map, const Vec3& point, double epsilon) {
    constexpr double last_places = 16;
    return last_places * epsilon * (norm(point) + norm(map.center) + norm(map.translation));
}

}  // namespace hexweave
