// SPDX-License-Identifier: Apache-2.0
#include "io/picture_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hexweave {

namespace {

/// The length of the UTF-8 sequence that starts at `at`; 0 when there is none.
std::size_t utf8_length(const std::string& text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(at);
    const std::size_t length = lead < 0x80                    ? 1
                               : lead >= 0xC2 && lead <= 0xDF ? 2
                               : lead >= 0xE0 && lead <= 0xEF ? 3
                               : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                              : 0;
    if (length == 0 || at + length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(at + i) & 0xC0U) != 0x80U) return 0;
    }
    if (length < 3) return length;
    const unsigned second = byte(at + 1);
    const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool outside = (lead == 0xED && second > 0x9F) || (lead == 0xF4 && second > 0x8F);
    return overlong || outside ? 0 : length;
}

}  // namespace

std::string printable(const std::string& text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_length(text, at);
        const auto lead = static_cast<unsigned char>(text[at]);
        const bool control = length == 1 && (lead < 0x20 || lead == 0x7F);
        result += length == 0 || control ? "?" : text.substr(at, length);
        at += std::max<std::size_t>(length, 1);
    }
    return result;
}

std::string xml_escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

double mark_distance(double length, int marks) {
    const double rough = length / marks;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double factor = rough / power;
    return power * (factor < 1.5 ? 1 : factor < 3.5 ? 2 : factor < 7.5 ? 5 : 10);
}

std::string mark_text(double value, double step) {
    if (std::abs(value) < 1e-9 * step) return "0";
    const double digits = -std::floor(std::log10(step) + 1e-9);
    if (std::abs(value) >= 1e6 || digits > 6) {
        const double significant = std::floor(std::log10(std::abs(value))) + digits + 1;
        return fmt::format("{:.{}g}", value, static_cast<int>(std::clamp(significant, 1.0, 16.0)));
    }
    return fmt::format("{:.{}f}", value, static_cast<int>(std::max(digits, 0.0)));
}

}  // namespace hexweave
