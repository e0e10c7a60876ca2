// SPDX-License-Identifier: Apache-2.0
#include "quality/angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/orientation.h"

namespace hexweave {

namespace {

/// The angles of the cells' quadrilaterals along axes a and b.
void include_plane(const PointField& x, int a, int b, AngleMeasure& measure) {
    const Extent e = x.extent();
    const auto point = [&](Node n, int da, int db) {
        n[static_cast<std::size_t>(a)] += da;
        n[static_cast<std::size_t>(b)] += db;
        return x(n[0], n[1], n[2]);
    };
    const int normal = 3 - a - b;
    const auto last = [&](int axis) { return axis == normal ? e[axis] - 1 : e[axis] - 2; };
    // Every quadrilateral inside a block is a side of two cells.
    for (int k = 0; k <= last(2); ++k) {
        for (int j = 0; j <= last(1); ++j) {
            for (int i = 0; i <= last(0); ++i) {
                const Node n{i, j, k};
                const int at = n[static_cast<std::size_t>(normal)];
                const bool inside = at > 0 && at < e[normal] - 1;
                const std::array<Vec3, 4> corners{point(n, 0, 0), point(n, 1, 0), point(n, 1, 1),
                                                  point(n, 0, 1)};
                for (std::size_t c = 0; c < 4; ++c) {
                    const Vec3 ahead = corners[(c + 1) % 4] - corners[c];
                    const Vec3 back = corners[(c + 3) % 4] - corners[c];
                    if (norm(ahead) == 0 || norm(back) == 0) continue;
                    const double angle = angle_between(ahead, back);
                    measure.include(angle, corners[c]);
                    if (inside) measure.include(angle, corners[c]);
                }
            }
        }
    }
}

}  // namespace

double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(norm(cross(a, b)), dot(a, b)) * (180 / std::numbers::pi);
}

void AngleMeasure::include(double angle, const Vec3& place) {
    const double off = std::abs(angle - 90);
    AngleMeasure one;
    one.corners = 1;
    one.within_5 = off <= 5 ? 1 : 0;
    one.within_10 = off <= 10 ? 1 : 0;
    one.least = one.greatest = angle;
    one.least_place = one.greatest_place = place;
    include(one);
}

void AngleMeasure::include(const AngleMeasure& other) {
    if (other.corners == 0) return;
    if (corners == 0 || other.least < least) {
        least = other.least;
        least_place = other.least_place;
    }
    if (corners == 0 || other.greatest > greatest) {
        greatest = other.greatest;
        greatest_place = other.greatest_place;
    }
    corners += other.corners;
    within_5 += other.within_5;
    within_10 += other.within_10;
}

AngleMeasure measure_angles(const PointField& points) {
    AngleMeasure measure;
    include_plane(points, 0, 1, measure);
    if (points.extent().nk > 1) {
        include_plane(points, 0, 2, measure);
        include_plane(points, 1, 2, measure);
    }
    return measure;
}

}  // namespace hexweave
