// SPDX-License-Identifier: Apache-2.0
// Stretching functions: cells + 1 fractions of a unit length, from exactly 0 to exactly 1. Sizes of
// cells are fractions too. Asked sizes are met to rounding: 1e-12 of themselves at the start; at
// the end as far as a fraction near 1 can tell.
//
// With `refinement` r every function gives r intervals for each of its cells: cells * r + 1
// fractions, of which every r-th is, to the bit, what it gives without (two cells of given
// sizes: to rounding), and between which the function itself is continued. Sizes are still those of
// the cells.
#pragma once

#include <optional>
#include <vector>

namespace hexweave {

/// Equal cells.
std::vector<double> uniform_fractions(int cells, int refinement = 1);

/// Vinokur's stretching functions [Vinokur 1983, J. Comput. Phys. 50, 215-234]: of tanh type for
/// small cells and of tan type for large ones. Both ends given: the two-sided function, its two
/// parameters chosen such that the first and last cells themselves, not the slopes at the ends, are
/// as asked. One end given: the one-sided function. None: uniform.
/// Precondition: sizes > 0; their sum < 1, or 1 where there are two cells (one cell: a size is 1).
std::vector<double> tanh_fractions(int cells, const std::optional<double>& first,
                                   const std::optional<double>& last, int refinement = 1);

/// Each cell `ratio` times the one before. Precondition: ratio > 0.
std::vector<double> ratio_fractions(int cells, double ratio, int refinement = 1);

/// Geometric growth that meets the given cells. One end given: one ratio all along. Both given: the
/// cells grow from both ends inwards by the same ratio until they meet (or shrink inwards, where
/// the ends are too large for that). None: uniform. Precondition: as for tanh_fractions.
std::vector<double> geometric_fractions(int cells, const std::optional<double>& first,
                                        const std::optional<double>& last, int refinement = 1);

/// The fractions 1 - f backwards: those of the same points seen from the other end.
std::vector<double> reversed_fractions(const std::vector<double>& fractions);

/// The smallest difference between neighbours; not a number where one is not.
double smallest_cell(const std::vector<double>& fractions);

}  // namespace hexweave
