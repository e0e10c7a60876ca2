// SPDX-License-Identifier: Apache-2.0
// Cell counts that are not taken as written: raised to whole numbers, to multiples, and such that
// the sums over opposite sides of faces stay equal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace hexweave {

/// What a face with a side of several edges says: the sum over one side equals that over the other.
struct SumEquation {
    int face = 0;
    std::size_t axis = 0;
    std::map<int, int> coefficients;  ///< of groups of edges; those that cancel are left out
};

/// What one group of parallel edges is to have.
struct WantedCount {
    double asked = 0;           ///< cells, not necessarily whole; 0: unknown
    std::int64_t multiple = 1;  ///< of which the cells are to be one
    bool fixed = false;         ///< is what it is: whole, whatever the multiple
};

struct RaisedCounts {
    std::vector<std::int64_t> cells;          ///< by group; 0 where unknown
    std::optional<std::size_t> unequal = {};  ///< an equation that could not be met
};

/// The least common multiple, but not more than 2^38: beyond any count that a grid can have.
std::int64_t common_multiple(std::int64_t a, std::int64_t b);

/// Every count raised to the next multiple (to rounding: 1e-9 above one it is that one). Where the
/// sides of a face then differ, the lesser side is raised on: that group of it which stands in
/// the fewest equations, of those the largest. Equations of unknown counts are left alone.
RaisedCounts raise_counts(const std::vector<WantedCount>& wanted,
                          const std::vector<SumEquation>& equations);

}  // namespace hexweave
