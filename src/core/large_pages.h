// SPDX-License-Identifier: Apache-2.0
// An allocator for large arrays that are walked over again and again: where the system offers pages
// of 2 MiB they are asked for, which spares most of the address translation.
#pragma once

#include <cstddef>
#include <new>

namespace hexweave {

/// Memory for `bytes`, not set to anything; throws std::bad_alloc.
void* allocate_pages(std::size_t bytes);
void free_pages(void* memory, std::size_t bytes);

template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class U>
    LargePages(const LargePages<U>&) {}  // NOLINT(google-explicit-constructor): allocators convert

    T* allocate(std::size_t count) { return static_cast<T*>(allocate_pages(count * sizeof(T))); }
    void deallocate(T* memory, std::size_t count) { free_pages(memory, count * sizeof(T)); }
    friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

}  // namespace hexweave
