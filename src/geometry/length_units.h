// SPDX-License-Identifier: Apache-2.0
// Units of length that files are in.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace hexweave {

struct LengthUnit {
    std::string_view name;
    double metres = 0;
};

inline constexpr std::array<LengthUnit, 10> length_units{{{"m", 1.0},
                                                          {"mm", 1e-3},
                                                          {"cm", 1e-2},
                                                          {"in", 0.0254},
                                                          {"ft", 0.3048},
                                                          {"km", 1e3},
                                                          {"mi", 1609.344},
                                                          {"mil", 2.54e-5},
                                                          {"um", 1e-6},
                                                          {"uin", 2.54e-8}}};

/// The unit of a name, or null.
inline const LengthUnit* find_length_unit(std::string_view name) {
    const auto* const found =
        std::find_if(length_units.begin(), length_units.end(),
                     [&](const LengthUnit& unit) { return unit.name == name; });
    return found == length_units.end() ? nullptr : &*found;
}

/// The unit of a length, or null.
inline const LengthUnit* find_length_unit(double metres) {
    const auto* const found =
        std::find_if(length_units.begin(), length_units.end(), [&](const LengthUnit& unit) {
            return std::abs(unit.metres - metres) < 1e-9 * unit.metres;
        });
    return found == length_units.end() ? nullptr : &*found;
}

}  // namespace hexweave
