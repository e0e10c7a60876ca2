// SPDX-License-Identifier: Apache-2.0
#include "quality/histogram.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace hexweave {

Histogram::Histogram(std::string name, std::vector<double> ascending_limits, bool is_small_bad)
    : measure(std::move(name)),
      limits(std::move(ascending_limits)),
      small_is_bad(is_small_bad),
      counts(limits.size() + 1) {}

void Histogram::include(double value) {
    if (std::isnan(value)) {
        ++(small_is_bad ? counts.front() : counts.back());
        return;
    }
    const auto above = std::upper_bound(limits.begin(), limits.end(), value);
    ++counts[static_cast<std::size_t>(above - limits.begin())];
}

void Histogram::include(const Histogram& other) {
    for (std::size_t n = 0; n < counts.size(); ++n) counts[n] += other.counts[n];
}

std::size_t Histogram::total() const {
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

}  // namespace hexweave
