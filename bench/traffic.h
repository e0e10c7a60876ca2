// SPDX-License-Identifier: Apache-2.0
// The memory traffic of the solver, counted by hand from its loops.
#pragma once

namespace hexweave::bench {

/// Bytes that one cycle on a block moves per point of its finest grid, all levels together, when
/// every array is read (written) once per pass over it: change it with the loops of src/elliptic.
/// Counted for a lean V(1,1) cycle: on the finest level about 900 bytes, times 4/3 for the rest.
inline constexpr double block_cycle_bytes_per_point = 1200;

}  // namespace hexweave::bench
