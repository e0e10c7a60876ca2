// SPDX-License-Identifier: Apache-2.0
// What the fuzzer has found interesting, and what it has found wrong once, in every build.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "fuzz/checked_case.h"

TEST_CASE("every text of the fuzzer's corpus is resolved, or refused with messages to read") {
    int texts = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(HEXWEAVE_SOURCE_DIR "/tests/fuzz/corpus")) {
        std::ifstream stream(entry.path(), std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(stream),
                               std::istreambuf_iterator<char>()};
        INFO(entry.path().filename().string());
        CHECK(hexweave::testing::broken_rule(text) == "");
        ++texts;
    }
    CHECK(texts >= 500);
}
