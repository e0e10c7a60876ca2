// SPDX-License-Identifier: Apache-2.0
// How many values lie between given limits.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace hexweave {

/// counts[0] are the values below limits[0], counts[n] those from limits[n - 1] to below limits[n],
/// and the last those from the last limit on. NaN counts as below all limits where small values are
/// bad, else as above all.
struct Histogram {
    std::string measure;
    std::vector<double> limits;
    bool small_is_bad = false;
    std::vector<std::size_t> counts;

    Histogram() = default;
    Histogram(std::string name, std::vector<double> ascending_limits, bool is_small_bad = false);

    void include(double value);
    void include(const Histogram& other);
    std::size_t total() const;
};

}  // namespace hexweave
