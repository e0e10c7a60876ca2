// SPDX-License-Identifier: Apache-2.0
// Distances from a wall, scaled near it only: how a first cell is brought to an asked height while
// the points farther out stay. For points along grid lines and for spacing laws of edges.
#pragma once

#include <cstddef>
#include <vector>

namespace hexweave {

/// distance * exp(log_factor * w): w falls from 1 at the first cell's height to 0 at `fade` like a
/// smooth step in the logarithm of the distance, so that a factor costs growth evenly over all
/// scales between the two. Distances from `fade` on are returned to the bit. `first` is the index
/// of the distance that is the first cell's height: those before it have the whole factor.
std::vector<double> scaled_distances(const std::vector<double>& distances, double log_factor,
                                     double fade, std::size_t first = 1);

/// The same with a logarithm for every distance.
std::vector<double> scaled_distances(const std::vector<double>& distances,
                                     const std::vector<double>& log_factors, double fade,
                                     std::size_t first = 1);

/// The greatest ratio of two neighbouring cells, either way, of the points at these distances;
/// infinite where they do not ascend.
double greatest_growth(const std::vector<double>& distances);

/// Vinokur's one-sided function with a first cell of `natural`, then scaled to `first` near the
/// start: from `within` on the points are those of `natural`. All sizes are fractions; counted from
/// the other end where `at_end`. `refinement` as for tanh_fractions.
std::vector<double> held_tanh_fractions(int cells, double first, double natural, double within,
                                        bool at_end, int refinement = 1);

}  // namespace hexweave
