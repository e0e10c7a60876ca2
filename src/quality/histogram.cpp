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

double Histogram::quantile(double part) const {
    const double wanted = part * static_cast<double>(total());
    double below = 0;
    for (std::size_t n = 0; n < limits.size(); ++n) {
        const auto here = static_cast<double>(counts[n]);
        if (here > 0 && below + here >= wanted) {
            const double low = n == 0 ? 0 : limits[n - 1];
            return low + (limits[n] - low) * std::max(0.0, wanted - below) / here;
        }
        below += here;
    }
    return below < wanted ? limits.back() : 0;
}

Histogram Histogram::coarsened(const std::vector<double>& some_limits) const {
    Histogram coarse(measure, some_limits, small_is_bad);
    for (std::size_t n = 0; n < counts.size(); ++n) {
        // A bin lies whole below its upper limit.
        const auto above = n == limits.size() ? some_limits.end()
                                              : std::lower_bound(some_limits.begin(),
                                                                 some_limits.end(), limits[n]);
        coarse.counts[static_cast<std::size_t>(above - some_limits.begin())] += counts[n];
    }
    return coarse;
}

}  // namespace hexweave
