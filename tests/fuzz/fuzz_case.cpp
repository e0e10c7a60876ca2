// SPDX-License-Identifier: Apache-2.0
// The entry of libFuzzer, run by tools/fuzz.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/checked_case.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string broken = hexweave::testing::broken_rule(std::string(data, data + size));
    if (broken.empty()) return 0;
    std::fprintf(stderr, "broken rule: %s\n", broken.c_str());
    std::abort();
}
