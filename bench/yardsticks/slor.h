// SPDX-License-Identifier: Apache-2.0
// Successive over-relaxation by lines across the clustered direction (j of a face, k of a block),
// line after line, the coefficients taken anew from the grid at every line. All components of a
// line share one tridiagonal matrix.
#pragma once

#include "bench/yardsticks/yardstick.h"

namespace hexweave::bench {

/// `relaxation`: above 0, below 2.
Yardstick line_relaxation(double relaxation);

}  // namespace hexweave::bench
