// SPDX-License-Identifier: Apache-2.0
#include "geometry/differences.h"

namespace hexweave {

/// The weights of f(0) ... f(8) for the derivative at node `at` of nodes one apart: the derivative
/// of the Lagrange polynomials.
Differences::Weights Differences::derivative_weights(int at) {
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

Differences::Differences(double begin, double end) : begin_(begin), end_(end) {
    // A power of two near 5e-4 of the range: small enough for 40 waves, large enough for the
    // rounding of f.
    step_ = std::exp2(std::floor(std::log2(5e-4 * (end - begin))));
    for (int at = 0; at < stencil_size; ++at) {
        weights_[static_cast<std::size_t>(at)] = derivative_weights(at);
    }
}

}  // namespace hexweave
