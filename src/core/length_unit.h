// SPDX-License-Identifier: Apache-2.0
// The units of length that files know: "m", "mm", "cm", "in", "ft".
#pragma once

#include <string_view>

namespace hexweave {

/// Metres in a unit of length; 1 when it is not known.
constexpr double metres_in(std::string_view unit) {
    if (unit == "mm") return 0.001;
    if (unit == "cm") return 0.01;
    if (unit == "in") return 0.0254;
    if (unit == "ft") return 0.3048;
    return 1;
}

}  // namespace hexweave
