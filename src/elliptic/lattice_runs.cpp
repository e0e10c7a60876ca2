// SPDX-License-Identifier: Apache-2.0
#include "elliptic/lattice_runs.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace hexweave {

namespace {

bool before(const Run& a, const Run& b) {
    return std::tie(a.k, a.j, a.first) < std::tie(b.k, b.j, b.first);
}

/// Every run repeated in the rows from -below to +above along j (axis 1) or k (axis 2).
Runs repeated(const Runs& runs, int axis, int below, int above, int low, int high) {
    Runs all;
    for (const Run& run : runs) {
        const int row = axis == 1 ? run.j : run.k;
        for (int r = std::max(low, row - below); r <= std::min(high, row + above); ++r) {
            all.push_back(run);
            (axis == 1 ? all.back().j : all.back().k) = r;
        }
    }
    return merged(std::move(all));
}

std::size_t root(std::vector<std::size_t>& parents, std::size_t member) {
    while (parents[member] != member) {
        parents[member] = parents[parents[member]];
        member = parents[member];
    }
    return member;
}

}  // namespace

Runs merged(Runs runs) {
    std::sort(runs.begin(), runs.end(), before);
    Runs result;
    for (const Run& run : runs) {
        if (!result.empty() && result.back().k == run.k && result.back().j == run.j &&
            run.first <= result.back().last + 1) {
            result.back().last = std::max(result.back().last, run.last);
        } else {
            result.push_back(run);
        }
    }
    return result;
}

Runs grown(const Runs& runs, const Reach& reach, const Node& low, const Node& high) {
    Runs longer;
    for (Run run : runs) {
        run.first = std::max(low[0], run.first - reach.below[0]);
        run.last = std::min(high[0], run.last + reach.above[0]);
        if (run.first <= run.last) longer.push_back(run);
    }
    const Runs wide =
        repeated(merged(std::move(longer)), 1, reach.below[1], reach.above[1], low[1], high[1]);
    return repeated(wide, 2, reach.below[2], reach.above[2], low[2], high[2]);
}

std::size_t find_run(const Runs& runs, int i, int j, int k) {
    const auto found = std::partition_point(runs.begin(), runs.end(), [&](const Run& run) {
        return std::tie(run.k, run.j, run.last) < std::tie(k, j, i);
    });
    return static_cast<std::size_t>(found - runs.begin());
}

std::vector<Runs> connected_parts(const Runs& runs) {
    std::vector<std::size_t> parents(runs.size());
    std::iota(parents.begin(), parents.end(), std::size_t{0});
    for (std::size_t r = 0; r < runs.size(); ++r) {
        for (const auto& [dk, dj] : {std::pair{0, 1}, {1, -1}, {1, 0}, {1, 1}}) {
            const int k = runs[r].k + dk;
            const int j = runs[r].j + dj;
            for (std::size_t q = find_run(runs, runs[r].first - 1, j, k);
                 q < runs.size() && runs[q].k == k && runs[q].j == j &&
                 runs[q].first <= runs[r].last + 1;
                 ++q) {
                const std::size_t a = root(parents, r);
                const std::size_t b = root(parents, q);
                parents[std::max(a, b)] = std::min(a, b);
            }
        }
    }
    std::vector<std::size_t> part_of(runs.size());
    std::vector<Runs> parts;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const std::size_t first = root(parents, r);
        if (first == r) {
            part_of[r] = parts.size();
            parts.emplace_back();
        }
        parts[part_of[first]].push_back(runs[r]);
    }
    return parts;
}

std::size_t count_members(const Runs& runs) {
    std::size_t count = 0;
    for (const Run& run : runs) count += static_cast<std::size_t>(run.length());
    return count;
}

std::vector<int> run_starts(const Runs& runs) {
    std::vector<int> starts(runs.size());
    int count = 0;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        starts[r] = count;
        count += runs[r].length();
    }
    return starts;
}

}  // namespace hexweave
