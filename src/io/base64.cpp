// SPDX-License-Identifier: Apache-2.0
#include "io/base64.h"

#include <cstddef>
#include <string_view>

namespace hexweave {

std::string to_base64(const std::vector<std::uint8_t>& bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t n = 0; n < bytes.size(); n += 3) {
        const std::size_t count = bytes.size() - n < 3 ? bytes.size() - n : 3;
        std::uint32_t group = 0;
        for (std::size_t b = 0; b < 3; ++b) {
            group = group << 8U | (b < count ? bytes[n + b] : 0U);
        }
        for (std::size_t d = 0; d < 4; ++d) {
            text += d <= count ? digits[group >> (18 - 6 * d) & 63U] : '=';
        }
    }
    return text;
}

}  // namespace hexweave
