// SPDX-License-Identifier: Apache-2.0
// Fixed tiles of an index range: what is summed over them is the same for any number of threads.
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/parallel.h"

namespace hexweave {

constexpr std::size_t tile_count(std::size_t count, std::size_t per_tile) {
    return (count + per_tile - 1) / per_tile;
}

/// Calls work(tile, begin, end) for every tile; several at a time where `shared`. Threads meet
/// after every call, which small ranges are not worth.
template <class Work>
void for_tiles(std::size_t count, std::size_t per_tile, bool shared, Work&& work) {
    const std::size_t tiles = tile_count(count, per_tile);
    const auto one = [&](std::size_t tile) {
        work(tile, tile * per_tile, std::min(count, (tile + 1) * per_tile));
    };
    if (!shared) {
        for (std::size_t tile = 0; tile < tiles; ++tile) one(tile);
    } else {
        parallel_for(tiles, one);
    }
}

}  // namespace hexweave
