// SPDX-License-Identifier: Apache-2.0
// The one file that names OpenMP. Independent tasks run at once; the result of a task never depends
// on which thread ran it.
#pragma once

#include <omp.h>

#include <cstddef>
#include <exception>

namespace hexweave {

inline void set_threads(int threads) {
    omp_set_num_threads(threads);
}
inline int threads() {
    return omp_get_max_threads();
}

/// Calls task(index) for every index below `count`, several at a time. The first exception (by
/// index) is thrown again after all tasks have ended.
template <class Task>
void parallel_for(std::size_t count, Task&& task) {
    std::exception_ptr failure;
    std::size_t failed_index = count;
#pragma omp parallel for schedule(dynamic, 1) default(shared)
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

}  // namespace hexweave
