// SPDX-License-Identifier: Apache-2.0
#include "io/plot3d_layout.h"

#include <array>

namespace hexweave {
namespace {

using Head = std::function<std::optional<std::int32_t>(const Plot3dLayout&, std::size_t)>;

/// A block of one node along i or j is a surface, whose points stand in the same order without that
/// axis.
Extent without_flat_axis(const Extent& extent) {
    if (extent.nk == 1) return extent;
    if (extent.ni == 1) return {extent.nj, extent.nk, 1};
    if (extent.nj == 1) return {extent.ni, extent.nk, 1};
    return extent;
}

/// Reads the sizes of all blocks; false when these are no sizes.
bool read_sizes(const Head& head, std::size_t most_nodes, Plot3dLayout& layout) {
    std::size_t place = 0;
    std::int32_t blocks = 1;
    if (layout.has_count) {
        const auto count = head(layout, place++);
        if (!count || *count < 1) return false;
        blocks = *count;
    }
    std::size_t nodes = 0;
    for (std::int32_t block = 0; block < blocks; ++block) {
        std::array<int, 3> size{1, 1, 1};
        double wanted = 1;
        for (int axis = 0; axis < layout.dimension; ++axis) {
            const auto number = head(layout, place++);
            if (!number || *number < 1) return false;
            size[static_cast<std::size_t>(axis)] = *number;
            wanted *= *number;
        }
        if (wanted > static_cast<double>(most_nodes)) return false;
        layout.extents.push_back(without_flat_axis({size[0], size[1], size[2]}));
        nodes += layout.extents.back().nodes();
        if (nodes > most_nodes) return false;
    }
    return true;
}

}  // namespace

std::vector<Plot3dLayout> possible_heads(const Head& head, std::size_t most_nodes) {
    std::vector<Plot3dLayout> found;
    for (const bool has_count : {true, false}) {
        for (const int dimension : {3, 2}) {
            Plot3dLayout layout;
            layout.has_count = has_count;
            layout.dimension = dimension;
            if (read_sizes(head, most_nodes, layout)) found.push_back(std::move(layout));
        }
    }
    return found;
}

}  // namespace hexweave
