// SPDX-License-Identifier: Apache-2.0
// What a Plot3D file can look like, and which of it a file does: shared by its reader and writer.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <vector>

#include "core/field.h"
#include "core/grid_output.h"

namespace hexweave {

/// The longest piece of a record between two 4-byte counts, as gfortran and ifort cut it.
inline constexpr std::size_t longest_subrecord = 2147483639;

/// Turns `count` numbers of `size` bytes from the machine's byte order into `order`, or back.
inline void to_order(unsigned char* bytes, std::size_t count, std::size_t size, ByteOrder order) {
    const bool is_little = std::endian::native == std::endian::little;
    if (is_little == (order == ByteOrder::little)) return;
    for (std::size_t n = 0; n < count; ++n) std::reverse(bytes + n * size, bytes + (n + 1) * size);
}

/// The choices that a Plot3D file does not tell.
struct Plot3dLayout {
    bool has_count = true;  ///< the number of blocks comes first
    int dimension = 3;      ///< coordinates, and numbers in a size
    bool has_blanking = false;
    std::size_t number_size = sizeof(double);
    std::vector<Extent> extents;  ///< of surfaces (ni, nj, 1), whichever axis the file has flat

    /// Numbers (coordinates) of one block.
    std::size_t numbers(const Extent& extent) const {
        return extent.nodes() * static_cast<std::size_t>(dimension);
    }
};

/// Calls `head` for the layouts that differ in their head alone: it gives the n-th whole number of
/// the file (those before it are known by then) or nothing. What is no head of a Plot3D file, or
/// promises more than `most_nodes`, is left out.
std::vector<Plot3dLayout> possible_heads(
    const std::function<std::optional<std::int32_t>(const Plot3dLayout&, std::size_t)>& head,
    std::size_t most_nodes);

}  // namespace hexweave
