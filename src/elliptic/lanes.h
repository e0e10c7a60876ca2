// SPDX-License-Identifier: Apache-2.0
// Eight floats side by side: the unit in which lines are relaxed. A compiler turns them into
// whatever vector instructions the machine has; the result is the same to the bit with any of them.
#pragma once

#include <cstddef>

namespace hexweave {

inline constexpr int lane_count = 8;

using Lanes [[gnu::vector_size(32)]] = float;

/// From and to any address: a copy, since compilers differ in what they make of a vector type that
/// is told to be less aligned.
[[gnu::always_inline]] inline Lanes load_lanes(const float* p) {
    Lanes lanes;
    __builtin_memcpy(&lanes, p, sizeof lanes);
    return lanes;
}
[[gnu::always_inline]] inline void store_lanes(float* p, Lanes lanes) {
    __builtin_memcpy(p, &lanes, sizeof lanes);
}

/// The same pointer, of which the compiler does not know where it comes from. In a loop over the
/// nodes of a row it would otherwise work out the address of every neighbour of every component
/// before the loop, some fifty of them, and fetch each from the stack again and again.
template <class T>
[[gnu::always_inline]] inline T* unrelated(T* p) {
    asm("" : "+r"(p));
    return p;
}

/// Half as many, for transposing.
using HalfLanes [[gnu::vector_size(16)]] = float;

[[gnu::always_inline]] inline HalfLanes load_half_lanes(const float* p) {
    HalfLanes lanes;
    __builtin_memcpy(&lanes, p, sizeof lanes);
    return lanes;
}
[[gnu::always_inline]] inline void store_half_lanes(float* p, HalfLanes lanes) {
    __builtin_memcpy(p, &lanes, sizeof lanes);
}

/// Writes the columns of the 4 x 4 numbers whose rows begin at from[0] .. from[3] to to[0] ..
/// to[3].
[[gnu::always_inline]] inline void transpose(const float* const (&from)[4], float* const (&to)[4]) {
    const HalfLanes a = load_half_lanes(from[0]);
    const HalfLanes b = load_half_lanes(from[1]);
    const HalfLanes c = load_half_lanes(from[2]);
    const HalfLanes d = load_half_lanes(from[3]);
    const HalfLanes ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const HalfLanes ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const HalfLanes cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const HalfLanes cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    store_half_lanes(to[0], __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5));
    store_half_lanes(to[1], __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7));
    store_half_lanes(to[2], __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5));
    store_half_lanes(to[3], __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7));
}

}  // namespace hexweave
