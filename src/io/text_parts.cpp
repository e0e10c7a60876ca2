// SPDX-License-Identifier: Apache-2.0
#include "io/text_parts.h"

#include <fmt/format.h>

#include <cstddef>

namespace hexweave {

std::string grouped(std::size_t number) {
    std::string digits = std::to_string(number);
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3) {
        digits.insert(static_cast<std::size_t>(at), ",");
    }
    return digits;
}

std::string counted(std::size_t number, const std::string& one, const std::string& more) {
    return grouped(number) + " " + (number == 1 ? one : more);
}
std::string counted(std::size_t number, const std::string& one) {
    return counted(number, one, one + "s");
}

std::string node_text(const Node& node, int axes) {
    std::string text = fmt::format("({}", node[0] + 1);
    for (int axis = 1; axis < axes; ++axis) {
        text += fmt::format(", {}", node[static_cast<std::size_t>(axis)] + 1);
    }
    return text + ")";
}

std::string place_text(const Vec3& p) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z);
}

}  // namespace hexweave
