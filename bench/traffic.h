// SPDX-License-Identifier: Apache-2.0
// The memory traffic of the solver, counted by hand from its loops.
#pragma once

namespace hexweave::bench {

/// Bytes that one cycle on a block moves per point of its finest grid, all levels together, when
/// every array is read (written) once per pass over it, and what is written is read first; change
/// it with the loops of src/elliptic. On the finest level: residuals 80 and their way down 84,
/// changes on their way up 128, coefficients 152, four passes of lines along k and three of lines
/// along i and j 504, corrections and displacement 144; times 5/3 for the coarser levels, the first
/// of which has half of the nodes and each other a quarter.
inline constexpr double block_cycle_bytes_per_point = 1820;

}  // namespace hexweave::bench
