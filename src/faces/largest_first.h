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

/// Calls task(index) for every index of `sizes`, several at a time and the largest first, so that a
/// big grid does not begin when all others are done. A single grid has all threads inside it.
/// `done` is called after each, never from two threads at once.
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
    if (order.size() == 1) {
        run(order.front());
    } else {
        parallel_for(order.size(), [&](std::size_t n) { run(order[n]); });
    }
}

}  // namespace hexweave
