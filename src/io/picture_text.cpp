// SPDX-License-Identifier: Apache-2.0
#include "io/picture_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "core/utf8.h"

namespace hexweave {

std::string printable(const std::string& text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const Utf8Character c = decode_utf8(std::string_view(text).substr(at));
        const bool control = c.code < 0x20 || c.code == 0x7F;
        result += !c.valid || control ? "?" : text.substr(at, c.bytes);
        at += c.bytes;
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
