// SPDX-License-Identifier: Apache-2.0
// The angles at which grid lines cross.
#pragma once

#include <cstddef>

#include "core/field.h"
#include "core/vec3.h"

namespace hexweave {

/// The corner angles of all cells, in degrees: four of a face's cell, twenty-four of a block's
/// (three at each corner). A corner without an angle, at a pole, does not count.
struct AngleMeasure {
    std::size_t corners = 0;
    std::size_t within_5 = 0;  ///< at most 5 degrees from 90
    std::size_t within_10 = 0;
    double least = 90;
    double greatest = 90;
    Vec3 least_place;
    Vec3 greatest_place;

    /// Of the corner farthest from 90 degrees.
    const Vec3& worst_place() const {
        return 90 - least >= greatest - 90 ? least_place : greatest_place;
    }
    void include(double angle, const Vec3& place);
    void include(const AngleMeasure& other);
};

/// The angle between two vectors in degrees; accurate at 0, 90 and 180 alike.
double angle_between(const Vec3& a, const Vec3& b);

AngleMeasure measure_angles(const PointField& points);

}  // namespace hexweave
