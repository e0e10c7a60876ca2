// SPDX-License-Identifier: Apache-2.0
#include "core/large_pages.h"

#include <sys/mman.h>

#include <cstdlib>

namespace hexweave {

namespace {

constexpr std::size_t page = std::size_t{2} << 20U;

std::size_t rounded(std::size_t bytes) {
    return (bytes + page - 1) / page * page;
}

}  // namespace

void* allocate_pages(std::size_t bytes) {
    if (bytes < page) {
        void* memory = std::aligned_alloc(64, (bytes + 63) / 64 * 64);
        if (memory == nullptr) throw std::bad_alloc();
        return memory;
    }
    void* memory = std::aligned_alloc(page, rounded(bytes));
    if (memory == nullptr) throw std::bad_alloc();
    // Only advice: where it is not taken, pages are small and all works as before.
    madvise(memory, rounded(bytes), MADV_HUGEPAGE);
    return memory;
}

void free_pages(void* memory, std::size_t /*bytes*/) {
    std::free(memory);
}

}  // namespace hexweave
