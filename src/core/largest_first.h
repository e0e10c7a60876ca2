// SPDX-License-Identifier: Apache-2.0
// The order in which independent grids are made, and how threads are shared among them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <mutex>
#include <numeric>
#include <vector>

#include "core/parallel.h"

namespace hexweave {

/// Grids of fewer nodes have too little to do for several threads inside.
inline constexpr std::size_t worth_all_threads = 20000;

/// How many of the grids, whose `sizes` (nodes) descend, are better made one after the other, with
/// all threads inside: those that have more to do than each thread's share of what is left. Were
/// they made with the others, one thread would still be at them when the rest are done.
inline std::size_t count_made_alone(const std::vector<std::size_t>& sizes, int threads) {
    std::size_t left = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
    std::size_t count = 0;
    for (const std::size_t size : sizes) {
        const bool exceeds_share = size > left / static_cast<std::size_t>(threads);
        if (threads == 1 || size < worth_all_threads || !exceeds_share) break;
        left -= size;
        ++count;
    }
    return count;
}

/// Calls task(index) for every index of `sizes`, the number of nodes of a grid, the largest first:
/// the largest ones alone (see count_made_alone), the rest several at a time, each on one thread.
/// `done` is called after each, never from two threads at once.
template <class Task>
void largest_first(const std::vector<std::size_t>& sizes, const std::function<void()>& done,
                   Task&& task) {
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
    std::vector<std::size_t> descending;
    descending.reserve(order.size());
    for (const std::size_t index : order) descending.push_back(sizes[index]);

    std::mutex one_at_a_time;
    const auto run = [&](std::size_t index) {
        task(index);
        if (!done) return;
        const std::lock_guard lock(one_at_a_time);
        done();
    };
    const std::size_t alone = count_made_alone(descending, threads());
    for (std::size_t n = 0; n < alone; ++n) run(order[n]);
    parallel_for(order.size() - alone, [&](std::size_t n) { run(order[alone + n]); });
}

}  // namespace hexweave
