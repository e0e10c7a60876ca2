// SPDX-License-Identifier: Apache-2.0
// The blocks of a C-O grid round a wing like the ONERA M6 (swept 30 degrees, taper 0.56, a NACA
// section 9.8 % thick, semispan 1.5): where sheets meet at 180 degrees and grids tend to fold.
#pragma once

#include <optional>

#include "bench/problems.h"

namespace hexweave::bench {

enum class Tip {
    revolved,  ///< the tip section revolved about its chord
    elliptic,  ///< the thickness fades over the outer tenth of the span
};

struct WingGrid {
    int points = 33;           ///< along each axis
    double first_cell = 1e-5;  ///< at the leading edge, in local chords; twice that at the trailing
    double tip_cell = 3e-3;    ///< beside the tip line
    Tip tip = Tip::revolved;
    double far = 10;  ///< radius of the far field
    double flat_edge_exponent = 1;
};

/// Over the upper side: i from the leading to the trailing edge, j from the root to the tip line, k
/// outwards. The sheet ahead of the leading edge and the one beyond the tip line meet at 180
/// degrees in the edge that leaves the tip of the leading edge. Nothing where a side face does not
/// converge.
std::optional<Problem> wing_block(const WingGrid& grid);

/// Behind it: i from the trailing edge to the outflow, j and k as above. The wake sheet and the
/// one beyond the tip meet at 180 degrees in the edge that leaves the tip of the trailing edge.
std::optional<Problem> wake_block(const WingGrid& grid);

}  // namespace hexweave::bench
