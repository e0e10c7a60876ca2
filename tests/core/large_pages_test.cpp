// SPDX-License-Identifier: Apache-2.0
// Memory for large arrays: zeroed by its containers, aligned, of any size.
#include "core/large_pages.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

using namespace hexweave;

TEST_CASE("arrays of any size hold their numbers and begin where vector registers may read") {
    for (const std::size_t count : {std::size_t{1}, std::size_t{100}, std::size_t{524288},
                                    std::size_t{524289}, std::size_t{1500000}}) {
        std::vector<float, LargePages<float>> numbers(count);
        CHECK(std::all_of(numbers.begin(), numbers.end(), [](float v) { return v == 0; }));
        CHECK(reinterpret_cast<std::uintptr_t>(numbers.data()) % 64 == 0);
        std::iota(numbers.begin(), numbers.end(), 1.0F);
        const std::vector<float, LargePages<float>> copy = numbers;
        numbers.clear();
        numbers.shrink_to_fit();
        CHECK(copy.front() == 1);
        CHECK(copy.back() == static_cast<float>(count));
    }
}

TEST_CASE("memory that there is not is told as the standard library tells it") {
    LargePages<double> pages;
    CHECK_THROWS_AS(pages.allocate(std::numeric_limits<std::size_t>::max() / 32), std::bad_alloc);
}
