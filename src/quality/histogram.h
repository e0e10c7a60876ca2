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
    /// The value that this part of all values (0 to 1) does not exceed, as if the values of a bin
    /// lay evenly between its limits: right to the width of the bin. Values below the first limit
    /// count from 0 on, those above the last as the last; of no values it is 0.
    double quantile(double part) const;
    /// The same values counted between some of the limits.
    Histogram coarsened(const std::vector<double>& some_limits) const;
};

}  // namespace hexweave
