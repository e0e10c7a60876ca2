// SPDX-License-Identifier: Apache-2.0
#include "quality/outline_parts.h"

#include <fmt/format.h>

namespace hexweave {

std::string to_text(const Extent& extent, int axes) {
    std::string text = std::to_string(extent.ni);
    for (int axis = 1; axis < axes; ++axis) text += fmt::format(" x {}", extent[axis]);
    return text;
}

std::string to_text(const Node& node, int axes) {
    std::string text = "[";
    for (int axis = 0; axis < axes; ++axis) {
        text += fmt::format("{}{}", axis > 0 ? ", " : "", node[static_cast<std::size_t>(axis)] + 1);
    }
    return text + "]";
}

std::string to_text(const IndexBox& box, int axes) {
    return to_text(box.begin, axes) + " to " + to_text(box.end, axes);
}

}  // namespace hexweave
