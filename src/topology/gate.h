// SPDX-License-Identifier: Apache-2.0
// Gates: what a grid must reach to count as sound, as asked under `require` in the file.
#pragma once

#include <string_view>
#include <vector>

#include "core/diagnostics.h"

namespace hexweave {

enum class GateMeasure {
    min_scaled_jacobian,  ///< over all corners of cells, flat ones and poles apart
    min_angle,            ///< degrees, over all corners of cells
    max_angle,
    max_skewness,        ///< equiangle: |angle - 90| / 90
    max_growth,          ///< of neighbouring intervals on a grid line, the longer over the shorter
    max_wall_angle,      ///< degrees off the normal of a wall, not beside its ends
    wall_spacing_error,  ///< relative, of the cells asked at ends of edges and of heights at walls
};
inline constexpr std::size_t gate_measures = 7;

/// The key in the file.
std::string_view gate_name(GateMeasure measure);
/// Whether the measure may not be below the limit, rather than not above.
constexpr bool is_lower_limit(GateMeasure measure) {
    return measure == GateMeasure::min_scaled_jacobian || measure == GateMeasure::min_angle;
}

struct Gate {
    GateMeasure measure = GateMeasure::min_scaled_jacobian;
    double limit = 0;
    Place place;
};

}  // namespace hexweave
