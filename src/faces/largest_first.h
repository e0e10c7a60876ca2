// SPDX-License-Identifier: Apache-2.0
// The order in which independent grids are made.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <mutex>
#include <numeric>
#include <vector>

#include "core/parallel.h"

namespace hexweave {

/// Calls task(index) for every index of `sizes`, the largest first, so that a big grid does not
/// begin when all others are done. A grid that alone is more than a thread's share of the work runs
/// by itself, with all threads inside it; the others run at once. `done` is called after each,
/// never from two threads at once.
template <class Task>
void largest_first(const std::vector<std::size_t>& sizes, const std::function<void()>& done,
                   Task&& task) {
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
    std::mutex one_at_a_time;
    const auto run = [&](std::size_t index) {
        task(index);
        if (!done) return;
        const std::lock_guard lock(one_at_a_time);
        done();
    };
    const std::size_t total = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
    const auto share = [&](std::size_t index) {
        return sizes[index] * static_cast<std::size_t>(threads()) > total;
    };
    std::size_t alone = 0;
    for (; alone < order.size() && share(order[alone]); ++alone) run(order[alone]);
    parallel_for(order.size() - alone, [&](std::size_t n) { run(order[alone + n]); });
}

}  // namespace hexweave
