// SPDX-License-Identifier: Apache-2.0
// Eight floats side by side: the unit in which lines are relaxed. A compiler turns them into
// whatever vector instructions the machine has; the result is the same to the bit with any of them.
#pragma once

#include <cstddef>

namespace hexweave {

inline constexpr int lane_count = 8;

/// May lie at any address.
using Lanes [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = float;

[[gnu::always_inline]] inline Lanes& lanes_at(float* p) {
    return *reinterpret_cast<Lanes*>(p);
}
[[gnu::always_inline]] inline const Lanes& lanes_at(const float* p) {
    return *reinterpret_cast<const Lanes*>(p);
}

}  // namespace hexweave
