// SPDX-License-Identifier: Apache-2.0
// The one file that names OpenMP. Independent tasks run at once; the result of a task never depends
// on which thread ran it.
#pragma once

#include <omp.h>

#include <algorithm>
#include <cstddef>
#include <exception>

namespace hexweave {

inline void set_threads(int threads) {
    omp_set_num_threads(threads);
}
inline int threads() {
    return omp_get_max_threads();
}

/// Calls task(index) for every index below `count`, several at a time; from within parallel_for
/// one after the other. The first exception (by index) is thrown again after all tasks have ended.
template <class Task>
void parallel_for(std::size_t count, Task&& task) {
    std::exception_ptr failure;
    std::size_t failed_index = count;
    const bool several = count > 1 && omp_in_parallel() == 0;
#pragma omp parallel for schedule(dynamic, 1) default(shared) if (several)
    for (std::size_t index = 0; index < count; ++index) {
        try {
            task(index);
        } catch (...) {
#pragma omp critical(hexweave_parallel_for)
            if (index < failed_index) {
                failed_index = index;
                failure = std::current_exception();
            }
        }
    }
    if (failure) std::rethrow_exception(failure);
}

/// Calls task(begin, end) for consecutive ranges that cover 0 .. count, one range per thread: for
/// loops inside a single grid. `cost` of one index is in rough nanoseconds; what is not worth
/// waking threads for, or is called from within parallel_for already, runs as one range. The task
/// must not throw, and must not depend on how the ranges are cut.
template <class Task>
void parallel_blocks(int count, int cost, Task&& task) {
    constexpr double worth_waking = 200000;
    const int ranges = omp_in_parallel() != 0 ? 1 : std::min(omp_get_max_threads(), count);
    if (ranges <= 1 || static_cast<double>(count) * cost < worth_waking) {
        if (count > 0) task(0, count);
        return;
    }
#pragma omp parallel for schedule(static, 1) num_threads(ranges) default(shared)
    for (int range = 0; range < ranges; ++range) {
        const auto cut = [&](int n) {
            return static_cast<int>(static_cast<long>(count) * n / ranges);
        };
        task(cut(range), cut(range + 1));
    }
}

}  // namespace hexweave
