// SPDX-License-Identifier: Apache-2.0
#include "core/utf8.h"

#include <catch2/catch.hpp>

#include "core/diagnostics.h"

using namespace hexweave;

TEST_CASE("the shortest and the longest character of each length are decoded") {
    const auto decoded = [](std::string_view text, std::uint32_t code, std::size_t bytes) {
        const Utf8Character c = decode_utf8(text);
        CHECK(c.valid);
        CHECK(c.code == code);
        CHECK(c.bytes == bytes);
    };
    decoded("A", 'A', 1);
    decoded("\x7F", 0x7F, 1);
    decoded("\xC2\x80", 0x80, 2);
    decoded("\xDF\xBF", 0x7FF, 2);
    decoded("\xE0\xA0\x80", 0x800, 3);
    decoded("\xED\x9F\xBF", 0xD7FF, 3);
    decoded("\xEF\xBF\xBF", 0xFFFF, 3);
    decoded("\xF0\x90\x80\x80", 0x10000, 4);
    decoded("\xF4\x8F\xBF\xBF", 0x10FFFF, 4);
}

TEST_CASE("what is no character is one byte that is not valid, and is shown as '?'") {
    for (const std::string broken : {
             "\x80",              // nothing before it
             "\xC3",              // cut off
             "\xC3(",             // not continued
             "\xC0\xAF",          // too long forms
             "\xC1\xBF",          //
             "\xE0\x9F\xBF",      //
             "\xF0\x8F\xBF\xBF",  //
             "\xED\xA0\x80",      // a surrogate
             "\xF4\x90\x80\x80",  // beyond U+10FFFF
             "\xF5\x89\x9A\x8D",  //
             "\xF8\x88\x80\x80",  // five and six bytes are no more
             "\xFF",
         }) {
        const Utf8Character c = decode_utf8(broken);
        CHECK_FALSE(c.valid);
        CHECK(c.bytes == 1);
        const auto source = std::make_shared<const SourceFile>(SourceFile{"f", "ab" + broken});
        Diagnostics diagnostics;
        diagnostics.error({source, 1, 3}, "wrong");
        CHECK(render(diagnostics).find("ab?") != std::string::npos);
        CHECK(render(diagnostics).find(broken[0]) == std::string::npos);
    }
}
