// SPDX-License-Identifier: Apache-2.0
// The box that points lie in.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "core/vec3.h"

namespace hexweave {

/// Empty, its least above its greatest, until a point is included.
struct PointBox {
    Vec3 least{infinity, infinity, infinity};
    Vec3 greatest{-infinity, -infinity, -infinity};

    void include(const Vec3& p) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
        greatest = {std::max(greatest.x, p.x), std::max(greatest.y, p.y),
                    std::max(greatest.z, p.z)};
    }

    std::array<Vec3, 8> corners() const {
        std::array<Vec3, 8> all;
        for (std::size_t n = 0; n < all.size(); ++n) {
            all[n] = {(n & 1) == 0 ? least.x : greatest.x, (n & 2) == 0 ? least.y : greatest.y,
                      (n & 4) == 0 ? least.z : greatest.z};
        }
        return all;
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();
};

}  // namespace hexweave
