// SPDX-License-Identifier: Apache-2.0
// Characters of UTF-8 text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hexweave {

/// The character that a text begins with.
struct Utf8Character {
    std::uint32_t code = 0;
    std::size_t bytes = 1;
    bool valid = false;
};

/// Decodes the first character of a text that is not empty [RFC 3629]. Where it is broken (cut off,
/// too long a form, a surrogate, beyond U+10FFFF) the one byte that it begins with is not valid.
Utf8Character decode_utf8(std::string_view text);

/// Whether a byte continues a character that began before it.
bool is_utf8_continuation(char byte);

}  // namespace hexweave
