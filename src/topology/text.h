// SPDX-License-Identifier: Apache-2.0
// Numbers and points as messages show them.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/vec3.h"

namespace hexweave {

inline std::string number_text(double value) {
    return fmt::format("{:.6g}", value);
}

/// [x, y], or [x, y, z] off the plane z = 0, as users write it. Round-off is shown as zero.
inline std::string point_text(const Vec3& p) {
    const double noise = 1e-12 * norm(p);
    const auto shown = [noise](double value) { return std::abs(value) <= noise ? 0.0 : value; };
    if (shown(p.z) == 0) return fmt::format("[{:.6g}, {:.6g}]", shown(p.x), shown(p.y));
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", shown(p.x), shown(p.y), shown(p.z));
}

}  // namespace hexweave
