// SPDX-License-Identifier: Apache-2.0
#include "core/turn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hexweave {

Turn turn_by_quarters(double quarters) {
    const double whole = std::round(quarters);
    const double angle = (quarters - whole) * (std::numbers::pi / 2);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    switch (static_cast<int>(std::fmod(whole, 4)) & 3) {
        case 0:
            return {c, s};
        case 1:
            return {-s, c};
        case 2:
            return {-c, -s};
        default:
            return {s, -c};
    }
}

Turn turn_by(double angle) {
    const double quarters = angle / (std::numbers::pi / 2);
    const double whole = std::round(quarters);
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const bool right_angles =
        std::abs(quarters - whole) <= 4 * epsilon * std::max(1.0, std::abs(whole));
    return right_angles ? turn_by_quarters(whole) : Turn{std::cos(angle), std::sin(angle)};
}

}  // namespace hexweave
