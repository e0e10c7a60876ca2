// SPDX-License-Identifier: Apache-2.0
// Derivatives of formulas by differences.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/vec3.h"

namespace hexweave {

/// Differences of eighth order on nine equidistant points that never leave the range [begin, end]:
/// centred inside, shifted near the ends. Accurate to about 1e-10 for a function with up to some 40
/// waves over the range. Precondition: begin < end.
class Differences {
public:
    Differences(double begin, double end);

    /// The derivative of f at t, begin <= t <= end.
    template <class Function>
    Vec3 operator()(Function&& f, double t) const {
        const int room_before = static_cast<int>(std::min((t - begin_) / step_, double{middle}));
        const int room_behind = static_cast<int>(std::min((end_ - t) / step_, double{middle}));
        const int at = room_behind < middle ? stencil_size - 1 - room_behind : room_before;
        const Weights& weights = weights_[static_cast<std::size_t>(at)];
        Vec3 sum;
        for (int j = 0; j < stencil_size; ++j) {
            const double weight = weights[static_cast<std::size_t>(j)];
            if (weight == 0) continue;
            sum += weight * f(std::clamp(t + (j - at) * step_, begin_, end_));
        }
        return sum / step_;
    }

private:
    static constexpr int stencil_size = 9;
    static constexpr int middle = stencil_size / 2;
    using Weights = std::array<double, stencil_size>;

    static Weights derivative_weights(int at);

    double begin_;
    double end_;
    double step_ = 1;
    std::array<Weights, stencil_size> weights_{};
};

}  // namespace hexweave
