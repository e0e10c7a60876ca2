// SPDX-License-Identifier: Apache-2.0
// How long a method takes until its grid is within 1 % and within 1e-4 of a cell of the true one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/problems.h"
#include "bench/yardsticks/yardstick.h"

namespace hexweave::bench {

/// The errors at which the clock is read, in cells.
inline constexpr double coarse_error = 1e-2;
inline constexpr double fine_error = 1e-4;

/// Single-core runs are timed by the processor time of this process: it does not count what others
/// take of the core.
enum class Clock { processor, wall };

struct Timing {
    double seconds = 0;
    int cycles = 0;
};

struct MethodRun {
    std::string problem;
    Extent extent;
    std::string family;
    std::string name;
    std::optional<Timing> to_coarse;
    std::optional<Timing> to_fine;
    double seconds = 0;          ///< until it was done or stopped
    bool diverged = false;       ///< otherwise, without `to_fine`, time ran out
    double bytes_per_point = 0;  ///< peak, beyond what was there before; 0 when not known

    double microseconds_per_point(const Timing& t) const {
        return 1e6 * t.seconds / static_cast<double>(extent.nodes());
    }
};

/// Runs a yardstick until it is within fine_error of `reference`, `limit` seconds have passed, or
/// its grid is no longer finite. The clock stands while the error is evaluated.
MethodRun time_yardstick(const Problem& problem, const PointField& reference,
                         const Yardstick& yardstick, double limit);

/// hexweave's own solver: the smallest numbers of cycles whose results are within coarse_error and
/// fine_error, then the median time of `repeats` runs with those numbers.
MethodRun time_own_solver(const Problem& problem, const PointField& reference, int repeats);

/// The smallest number of hexweave's cycles whose result is within `goal` of `reference`; nothing
/// where hundreds are not enough.
std::optional<int> cycles_to(const Problem& problem, const PointField& reference, double goal);

/// Seconds of one run of hexweave's solver with exactly so many cycles (fewer where it is done).
double time_cycles(const Problem& problem, int cycles, Clock clock = Clock::processor);
double median(std::vector<double> values);

/// The grid that errors are measured against, and how far it was verified.
struct Reference {
    PointField points;
    SolveResult solve;
    double residual = 0;  ///< in cells, evaluated apart
    bool trusted() const;
};

Reference converged_grid(const Problem& problem);

}  // namespace hexweave::bench
