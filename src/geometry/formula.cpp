// SPDX-License-Identifier: Apache-2.0
#include "geometry/formula.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace hexweave {

namespace {

constexpr int stencil_size = 9;
using Weights = std::array<double, stencil_size>;

/// The weights of f(0) ... f(8) for the derivative at node `at` of nodes one apart: the derivative
/// of the Lagrange polynomials.
Weights derivative_weights(int at) {
    const auto product_of_differences = [](int k) {
        double product = 1;
        for (int m = 0; m < stencil_size; ++m) {
            if (m != k) product *= k - m;
        }
        return product;
    };
    Weights weights{};
    for (int j = 0; j < stencil_size; ++j) {
        if (j == at) continue;
        weights[static_cast<std::size_t>(j)] =
            product_of_differences(at) / product_of_differences(j) / (at - j);
        weights[static_cast<std::size_t>(at)] += 1.0 / (at - j);
    }
    return weights;
}

/// Differences on nine equidistant points: centred inside, shifted near the ends.
class Differences {
public:
    Differences(std::function<Vec3(double)> f, double begin, double end)
        : f_(std::move(f)), begin_(begin), end_(end) {
        // A power of two near 5e-4 of the range: small enough for 40 waves, large enough for the
        // rounding of f.
        step_ = std::exp2(std::floor(std::log2(5e-4 * (end - begin))));
        for (int at = 0; at < stencil_size; ++at) {
            weights_[static_cast<std::size_t>(at)] = derivative_weights(at);
        }
    }

    Vec3 operator()(double t) const {
        constexpr int middle = stencil_size / 2;
        const int room_before = static_cast<int>(std::min((t - begin_) / step_, double{middle}));
        const int room_behind = static_cast<int>(std::min((end_ - t) / step_, double{middle}));
        const int at = room_behind < middle ? stencil_size - 1 - room_behind : room_before;
        const Weights& weights = weights_[static_cast<std::size_t>(at)];
        Vec3 sum;
        for (int j = 0; j < stencil_size; ++j) {
            const double weight = weights[static_cast<std::size_t>(j)];
            if (weight == 0) continue;
            sum += weight * f_(std::clamp(t + (j - at) * step_, begin_, end_));
        }
        return sum / step_;
    }

private:
    std::function<Vec3(double)> f_;
    double begin_;
    double end_;
    double step_ = 1;
    std::array<Weights, stencil_size> weights_{};
};

/// Do the ends coincide, measured against how far the curve reaches?
bool ends_coincide(const std::function<Vec3(double)>& position, double begin, double end) {
    constexpr int samples = 16;
    const Vec3 first = position(begin);
    double reach = 0;
    for (int k = 1; k < samples; ++k) {
        reach = std::max(reach, distance(first, position(begin + (end - begin) * k / samples)));
    }
    return distance(first, position(end)) <= 1e-12 * reach;
}

}  // namespace

Curve formula(std::function<Vec3(double)> position, double begin, double end) {
    Curve curve;
    curve.begin = begin;
    curve.end = end;
    curve.closed = ends_coincide(position, begin, end);
    curve.derivative = Differences(position, begin, end);
    curve.position = std::move(position);
    if (curve.closed) {
        curve.position = [open = std::move(curve.position), begin, end](double t) {
            return open(t == end ? begin : t);
        };
    }
    return curve;
}

}  // namespace hexweave
