// SPDX-License-Identifier: Apache-2.0
#include "topology/adjusted_counts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <tuple>

namespace hexweave {

namespace {

constexpr std::int64_t most = std::int64_t{1} << 38;

/// The least multiple that is not below `asked`.
std::int64_t next_multiple(double asked, std::int64_t multiple) {
    constexpr double rounding = 1e-9;
    const double parts = std::min(asked, static_cast<double>(most)) / static_cast<double>(multiple);
    return static_cast<std::int64_t>(std::max(1.0, std::ceil(parts * (1 - rounding)))) * multiple;
}

struct Balance {
    const std::vector<WantedCount>& wanted;
    const std::vector<SumEquation>& equations;
    std::vector<std::int64_t> cells;
    std::vector<int> uses;  ///< equations in which each group stands

    /// One side's sum less the other's; nothing to balance, 0, where a count is unknown.
    std::int64_t excess(const SumEquation& equation) const {
        std::int64_t sum = 0;
        for (const auto& [group, coefficient] : equation.coefficients) {
            const std::int64_t count = cells[static_cast<std::size_t>(group)];
            if (count == 0) return 0;
            sum += coefficient * count;
        }
        return sum;
    }

    /// Raises a group on the lesser side; false where none can be.
    bool raise_lesser_side(const SumEquation& equation, std::int64_t excess) {
        int best = -1;
        const auto preference = [&](int group) {
            const auto g = static_cast<std::size_t>(group);
            return std::tuple(-uses[g], cells[g], -group);
        };
        for (const auto& [group, coefficient] : equation.coefficients) {
            const bool lesser = (coefficient > 0) != (excess > 0);
            if (!lesser || wanted[static_cast<std::size_t>(group)].fixed) continue;
            if (best < 0 || preference(group) > preference(best)) best = group;
        }
        if (best < 0) return false;
        const auto g = static_cast<std::size_t>(best);
        const std::int64_t step = wanted[g].multiple * std::abs(equation.coefficients.at(best));
        cells[g] += (std::abs(excess) + step - 1) / step * wanted[g].multiple;
        return cells[g] < most;
    }
};

}  // namespace

std::int64_t common_multiple(std::int64_t a, std::int64_t b) {
    return std::min(most, a / std::gcd(a, b) * b);
}

RaisedCounts raise_counts(const std::vector<WantedCount>& wanted,
                          const std::vector<SumEquation>& equations) {
    Balance balance{wanted, equations, {}, std::vector<int>(wanted.size())};
    for (const WantedCount& w : wanted) {
        const std::int64_t multiple = w.fixed ? 1 : w.multiple;
        balance.cells.push_back(w.asked > 0 ? next_multiple(w.asked, multiple) : 0);
    }
    for (const SumEquation& equation : equations) {
        for (const auto& term : equation.coefficients) {
            ++balance.uses[static_cast<std::size_t>(term.first)];
        }
    }
    // Each pass mends every equation; what one spoils of another is passed on along the grid.
    const std::size_t passes = equations.size() + 10;
    std::optional<std::size_t> unequal;
    for (std::size_t pass = 0; pass < passes; ++pass) {
        unequal.reset();
        for (std::size_t e = 0; e < equations.size(); ++e) {
            const std::int64_t excess = balance.excess(equations[e]);
            if (excess == 0) continue;
            unequal = e;
            if (!balance.raise_lesser_side(equations[e], excess)) return {balance.cells, e};
        }
        if (!unequal) break;
    }
    return {std::move(balance.cells), unequal};
}

}  // namespace hexweave
